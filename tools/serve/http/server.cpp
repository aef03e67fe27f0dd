// SPDX-License-Identifier: Apache-2.0
// The library behind library.hpp.
#include <microhttpd.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <memory>
#include <new>

#include "serve/http/library.hpp"

namespace epura::http {

namespace {

// A page makes a few connections. Headers and the address of a request share the memory of its connection. Any program
// on this computer can connect: those that have not shown the token leave room for the page, and their place to others.
constexpr unsigned max_connections = 64;
constexpr std::size_t max_strangers = 32;
constexpr unsigned idle_seconds = 20;
constexpr std::chrono::seconds max_for_stranger(10);  // a browser sends the head of a request at once
constexpr std::size_t bytes_of_connection = 16384;

/// A request from its first line to the end of its reply.
struct Exchange {
  Server* server;
  MHD_Connection* connection;
  std::uint64_t number = 0;  ///< 0: it has not been handed over
  bool has_reply = false;
  Reply reply{};
};

using Clock = std::chrono::steady_clock;

/// A client, from its connection to its end.
struct Client {
  MHD_Connection* connection;
  bool is_stranger = true;  ///< it has not shown the token, nor asked what is not answered yet
  Clock::time_point since = Clock::now();
};

// The server notices the end of the connection by itself, a moment later.
void hang_up(Client& client) {
  client.is_stranger = false;
  if (const MHD_ConnectionInfo* info = MHD_get_connection_info(client.connection, MHD_CONNECTION_INFO_CONNECTION_FD))
    ::shutdown(info->connect_fd, SHUT_RDWR);
}

// A path is text that ends with its first NUL: one that is encoded stays so, and leads nowhere.
std::size_t unescape(void* /*server*/, MHD_Connection* /*connection*/, char* text) {
  return std::strstr(text, "%00") != nullptr ? std::strlen(text) : MHD_http_unescape(text);
}

MHD_Result add_field(void* fields, MHD_ValueKind kind, const char* name, const char* value) {
  std::string key = name;
  if (kind == MHD_HEADER_KIND)
    std::transform(key.begin(), key.end(), key.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  static_cast<Fields*>(fields)->emplace_back(std::move(key), value == nullptr ? "" : value);
  return MHD_YES;
}

void free_body(void* body) { delete static_cast<std::shared_ptr<const std::string>*>(body); }

MHD_Result send(MHD_Connection* connection, const Reply& reply) {
  static const auto empty = std::make_shared<const std::string>();
  auto body = std::make_unique<std::shared_ptr<const std::string>>(reply.body ? reply.body : empty);
  // The library does not write to the bytes.
  char* bytes = const_cast<char*>((*body)->data());
  MHD_Response* response =
      MHD_create_response_from_buffer_with_free_callback_cls((*body)->size(), bytes, free_body, body.get());
  if (response == nullptr) return MHD_NO;
  static_cast<void>(body.release());
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, reply.type.c_str());
  for (const auto& [name, value] : reply.headers) MHD_add_response_header(response, name.c_str(), value.c_str());
  const MHD_Result result = MHD_queue_response(connection, reply.status, response);
  MHD_destroy_response(response);
  return result;
}

Reply short_reply(unsigned status, const char* sentence) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(sentence), {}};
}

bool has_body(MHD_Connection* connection) {
  const auto given = [&](const char* name) {
    return MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name) != nullptr;
  };
  return given(MHD_HTTP_HEADER_CONTENT_LENGTH) || given(MHD_HTTP_HEADER_TRANSFER_ENCODING);
}

}  // namespace

class Server {
 public:
  explicit Server(int socket)
      : daemon_(MHD_start_daemon(MHD_USE_EPOLL | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr, handle, this,
                                 MHD_OPTION_LISTEN_SOCKET, socket, MHD_OPTION_CONNECTION_LIMIT, max_connections,
                                 MHD_OPTION_CONNECTION_TIMEOUT, idle_seconds, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
                                 bytes_of_connection, MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_NOTIFY_COMPLETED,
                                 forget, this, MHD_OPTION_NOTIFY_CONNECTION, come_or_go, this,
                                 MHD_OPTION_UNESCAPE_CALLBACK, unescape, nullptr, MHD_OPTION_END)) {}

  [[nodiscard]] bool is_started() const { return daemon_ != nullptr; }
  [[nodiscard]] int descriptor() const { return MHD_get_daemon_info(daemon_, MHD_DAEMON_INFO_EPOLL_FD)->epoll_fd; }
  [[nodiscard]] int wait_ms() {
    // The descriptor does not tell of connections that were resumed.
    if (has_resumed_) return 0;
    MHD_UNSIGNED_LONG_LONG ms = 0;
    constexpr MHD_UNSIGNED_LONG_LONG longest = 1000;
    if (MHD_get_timeout(daemon_, &ms) != MHD_YES) return clients_.empty() ? -1 : static_cast<int>(longest);
    return static_cast<int>(std::min(ms, longest));
  }
  [[nodiscard]] std::vector<Request> take() {
    has_resumed_ = false;
    const Clock::time_point now = Clock::now();
    for (Client& client : clients_)
      if (client.is_stranger && now - client.since > max_for_stranger) hang_up(client);
    MHD_run(daemon_);
    return std::exchange(requests_, {});
  }
  void reply(std::uint64_t number, Reply reply) {
    const auto found = waiting_.find(number);
    if (found == waiting_.end()) return;
    Exchange* exchange = found->second;
    waiting_.erase(found);
    exchange->reply = std::move(reply);
    exchange->has_reply = true;
    MHD_resume_connection(exchange->connection);
    has_resumed_ = true;
  }

 private:
  // Called when the headers are there, when the request is complete, and when it goes on with its reply.
  static MHD_Result handle(void* server, MHD_Connection* connection, const char* url, const char* method,
                           const char* /*version*/, const char* /*upload*/, std::size_t* upload_size, void** state) {
    try {
      if (*state != nullptr) {
        auto* exchange = static_cast<Exchange*>(*state);
        if (exchange->has_reply) {
          if (exchange->reply.is_refusal) static_cast<Server*>(server)->client_of(connection).is_stranger = true;
          return send(connection, exchange->reply);
        }
        *upload_size = 0;
        static_cast<Server*>(server)->hand_over(*exchange, url);
        return MHD_YES;
      }
      *state = new Exchange{static_cast<Server*>(server), connection};
      if (std::strcmp(method, MHD_HTTP_METHOD_GET) != 0) {
        Reply refusal = short_reply(MHD_HTTP_METHOD_NOT_ALLOWED, "only GET is allowed\n");
        refusal.headers.emplace_back(MHD_HTTP_HEADER_ALLOW, MHD_HTTP_METHOD_GET);
        return send(connection, refusal);
      }
      if (has_body(connection))
        return send(connection, short_reply(MHD_HTTP_CONTENT_TOO_LARGE, "a request has no body\n"));
      return MHD_YES;
    } catch (const std::bad_alloc&) {
      return MHD_NO;  // ends the connection
    }
  }

  // Called when the reply has been sent, or the connection has ended before.
  static void forget(void* server, MHD_Connection* /*connection*/, void** state, MHD_RequestTerminationCode /*why*/) {
    auto* exchange = static_cast<Exchange*>(std::exchange(*state, nullptr));
    if (exchange != nullptr) static_cast<Server*>(server)->waiting_.erase(exchange->number);
    delete exchange;
  }

  // Called when a connection begins, and when it has ended.
  static void come_or_go(void* server, MHD_Connection* connection, void** /*state*/,
                         MHD_ConnectionNotificationCode event) {
    auto& clients = static_cast<Server*>(server)->clients_;
    if (event == MHD_CONNECTION_NOTIFY_CLOSED)
      std::erase_if(clients, [&](const Client& client) { return client.connection == connection; });
    else
      clients.push_back({connection});
    const auto is_stranger = [](const Client& client) { return client.is_stranger; };
    if (static_cast<std::size_t>(std::count_if(clients.begin(), clients.end(), is_stranger)) > max_strangers)
      hang_up(*std::find_if(clients.begin(), clients.end(), is_stranger));  // the oldest
  }

  Client& client_of(MHD_Connection* connection) {
    return *std::find_if(clients_.begin(), clients_.end(),
                         [&](const Client& client) { return client.connection == connection; });
  }

  void hand_over(Exchange& exchange, const char* url) {
    client_of(exchange.connection).is_stranger = false;
    Request request{++last_, url, {}, {}};
    MHD_get_connection_values(exchange.connection, MHD_GET_ARGUMENT_KIND, add_field, &request.arguments);
    MHD_get_connection_values(exchange.connection, MHD_HEADER_KIND, add_field, &request.headers);
    exchange.number = last_;
    waiting_[last_] = &exchange;
    requests_.push_back(std::move(request));
    MHD_suspend_connection(exchange.connection);
  }

  std::vector<Client> clients_{};  ///< in the order in which they came
  std::vector<Request> requests_{};
  std::map<std::uint64_t, Exchange*> waiting_{};
  std::uint64_t last_ = 0;
  bool has_resumed_ = false;
  MHD_Daemon* daemon_;
};

namespace {

// The server ends with its process.
Server* start(int socket) {
  auto server = std::make_unique<Server>(socket);
  return server->is_started() ? server.release() : nullptr;
}
int descriptor(const Server& server) { return server.descriptor(); }
int wait_ms(Server& server) { return server.wait_ms(); }
std::vector<Request> take(Server& server) { return server.take(); }
void reply(Server& server, std::uint64_t number, Reply answer) { server.reply(number, std::move(answer)); }

}  // namespace

}  // namespace epura::http

// The program finds the functions by this name.
extern "C" {
__attribute__((visibility("default"))) extern const epura::http::Library epura_http_library;
const epura::http::Library epura_http_library{epura::http::start, epura::http::descriptor, epura::http::wait_ms,
                                              epura::http::take, epura::http::reply};
}
