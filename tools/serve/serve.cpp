// SPDX-License-Identifier: Apache-2.0
#include "serve/serve.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "importer/read_model.hpp"
#include "output/html.hpp"
#include "output/json_text.hpp"
#include "serve/admission.hpp"
#include "serve/drawings.hpp"
#include "serve/http/library.hpp"
#include "serve/play_parts.hpp"
#include "serve/seen_model.hpp"

namespace epura {

namespace {

/// `title` is text, `data` JSON.
std::string play_page(const std::string& title, const std::string& data) {
  return output::filled_page(play_frame, {{"title", output::html_text(title)},
                                          {"style", std::string(play_style)},
                                          {"script", std::string(play_script)},
                                          {"data", output::within_script(data)}});
}

/// Its Content-Security-Policy: its own script and style sheet, requests to its own server, and pictures made of them.
std::string play_policy() {
  return output::content_policy(play_script_hash, play_style_hash, "img-src blob: data:; connect-src 'self'") +
         "; frame-ancestors 'none'";
}

using Clock = Drawings::Clock;

// Only this computer can connect to it.
int listening_socket(int port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  // Otherwise a port stays taken for a minute after its last connection.
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  constexpr int waiting = 64;
  if (socket >= 0 && ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(socket, waiting) == 0)
    return socket;
  const int reason = errno;
  const std::string place = port > 0 ? "--port " + std::to_string(port) : "serve";
  if (reason == EADDRINUSE)
    throw Error(ErrorKind::output, place, "another program uses this port", "choose another one, or omit --port");
  throw Error(ErrorKind::output, place, std::string("cannot listen on 127.0.0.1: ") + std::strerror(reason));
}

int port_of(int socket) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0)
    throw Error(ErrorKind::output, "serve", std::string("has no port: ") + std::strerror(errno));
  return ntohs(address.sin_port);
}

// What is read again for each drawing is a file.
void expect_files(const std::vector<std::string>& models) {
  for (const std::string& model : models) {
    const std::string path = importer::parse_model_request(model).path;
    if (path == importer::standard_input)
      throw Error(ErrorKind::input, model, "cannot be read again for each drawing", "name a file");
    if (to_lower(std::filesystem::path(path).extension().string()) == ".toml")
      throw Error(ErrorKind::input, model, "is a scene file, which chooses its views itself",
                  "name one of its models, and 'epura draw' for the scene");
  }
}

std::shared_ptr<const std::string> shared(std::string bytes) {
  return std::make_shared<const std::string>(std::move(bytes));
}

class PlayServer {
 public:
  PlayServer(const ServeOptions& options, int socket)
      : options_(options),
        http_(http::library()),
        address_{port_of(socket), make_token()},
        ready_(start_model(model_, options)),
        drawings_(options, [this](std::uint64_t request, http::Reply reply) { send(request, std::move(reply)); }) {
    const std::string path = importer::parse_model_request(options.draw.models.front()).path;
    title_ = std::filesystem::path(path).filename().string();
    const auto [before, after] = command_around_projection(options);
    page_ = shared(play_page(
        title_, "{\"title\": " + output::json_string(title_) + ", \"before\": " + output::json_string(before) +
                    ", \"after\": " + output::json_string(after) + ", \"model\": " + ready_.page_data + "}"));
    wireframe_ = shared(std::move(ready_.wireframe));
    server_ = http_.start(socket);
    if (server_ == nullptr) throw Error(ErrorKind::output, "serve", "there is too little memory for the server");
  }

  [[nodiscard]] std::string url() const { return address_.url(); }

  [[noreturn]] void run() {
    while (true) {
      for (const http::Request& request : http_.take(*server_)) answer(request);
      look_at_view();
      drawings_.look();
      wait();
    }
  }

 private:
  struct View {
    std::uint64_t request;
    std::string page, projection;
  };

  void send(std::uint64_t request, http::Reply reply) {
    const bool is_page = reply.type.starts_with("text/html");
    for (const auto& [name, value] :
         http::Fields{{"Cache-Control", "no-store"},
                      {"X-Content-Type-Options", "nosniff"},
                      {"Referrer-Policy", "no-referrer"},
                      {"Cross-Origin-Resource-Policy", "same-origin"},
                      {"Cross-Origin-Opener-Policy", "same-origin"},
                      {"Content-Security-Policy",
                       is_page ? play_policy()
                               : "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'none'; sandbox"}})
      reply.headers.emplace_back(name, value);
    http_.reply(*server_, request, std::move(reply));
  }

  void send_error(std::uint64_t request, unsigned status, const std::string& reason, const std::string& hint = {}) {
    send(request, {status, "application/json", shared(error_json(reason, hint)), {}});
  }

  void answer(const http::Request& request) {
    if (const auto reason = reason_to_refuse(request, address_))
      return send(request.number, {403, "text/plain; charset=utf-8", shared(*reason + "\n"), {}, true});
    const std::string resource = resource_of(request, address_);
    if (resource.empty()) return send(request.number, {200, "text/html; charset=utf-8", page_, {}});
    if (resource == "model") return send(request.number, {200, "application/octet-stream", wireframe_, {}});
    if (resource != "view" && resource != "drawing") return send_error(request.number, 404, "there is nothing here");
    const std::string page = argument_of(request, "page"), projection = argument_of(request, "projection");
    if (projection.empty())
      return send_error(request.number, 400, "no projection is named", resource + "?projection=isometric");
    if (resource == "drawing") return drawings_.ask(request.number, page, projection);
    const auto is_older = [&](const View& view) { return !page.empty() && view.page == page; };
    for (const View& view : views_)
      if (is_older(view)) send_error(view.request, 409, "a newer request has taken its place");
    std::erase_if(views_, is_older);
    views_.push_back({request.number, page, projection});
    ask_next();
  }

  // One view at a time is asked for: each takes milliseconds.
  void ask_next() {
    if (asked_ || views_.empty()) return;
    asked_ = std::move(views_.front());
    views_.pop_front();
    until_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.job_time));
    try {
      if (!model_.is_there()) static_cast<void>(start_model(model_, options_));
      ask_for_view(model_, asked_->projection);
    } catch (const Error& error) {
      fail(error.what(), error.hint());
    }
  }

  void look_at_view() {
    if (!asked_) return;
    try {
      if (const auto answer = take_view(model_)) {
        send(std::exchange(asked_, {})->request,
             {answer->is_good ? 200U : 400U, "application/json", shared(answer->json), {}});
        ask_next();
      } else if (Clock::now() >= until_) {
        fail("the view takes more than " + format_number(options_.job_time) + " s", "serve with a larger --job-time");
      }
    } catch (const Error& error) {
      fail(std::string("the process of the model ") + error.what(), "");
    }
  }

  // The next view gets another process.
  void fail(const std::string& reason, const std::string& hint) {
    model_.end();
    send_error(std::exchange(asked_, {})->request, 500, reason, hint);
    ask_next();
  }

  void wait() {
    std::vector<pollfd> descriptors{{http_.descriptor(*server_), POLLIN, 0}};
    for (const int descriptor : drawings_.descriptors()) descriptors.push_back({descriptor, POLLIN, 0});
    Clock::time_point deadline = drawings_.deadline();
    if (asked_) {
      descriptors.push_back({model_.socket(), POLLIN, 0});
      deadline = std::min(deadline, until_);
    }
    int wait_ms = http_.wait_ms(*server_);
    if (deadline != Clock::time_point::max()) {
      constexpr long long longest = 1000;
      const long long left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
      const int until_deadline = static_cast<int>(std::clamp(left, 0LL, longest));
      wait_ms = wait_ms < 0 ? until_deadline : std::min(wait_ms, until_deadline);
    }
    ::poll(descriptors.data(), descriptors.size(), wait_ms);
  }

  const ServeOptions& options_;
  const http::Library& http_;
  ServedAddress address_;
  foreign::ChildProcess model_{};
  ReadyModel ready_;
  Drawings drawings_;
  std::string title_;
  std::shared_ptr<const std::string> page_, wireframe_;
  http::Server* server_ = nullptr;
  std::deque<View> views_{};     ///< not asked for yet
  std::optional<View> asked_{};  ///< of the process of the model
  Clock::time_point until_{};
};

}  // namespace

int serve(const ServeOptions& options) {
  expect_files(options.draw.models);
  ProgressBoard board;
  const Console console(board, false);
  const int socket = listening_socket(options.port);
  PlayServer server(options, socket);
  std::printf("%s\n", server.url().c_str());
  std::fflush(stdout);
  server.run();
}

}  // namespace epura
