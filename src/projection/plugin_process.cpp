// SPDX-License-Identifier: Apache-2.0
#include "projection/plugin_process.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "base/text.hpp"
#include "projection/answer.hpp"
#include "projection/loader.hpp"
#include "projection/packing.hpp"

namespace epura::projection {

namespace {

using Clock = std::chrono::steady_clock;

/// What the other side sent is longer only if it was damaged.
constexpr std::size_t most_bytes = std::size_t{1} << 28;

bool send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool send_message(int socket, const Packer& message) {
  Packer size;
  size(message.bytes().size());
  return send_all(socket, size.bytes()) && send_all(socket, message.bytes());
}

enum class Received { all, nothing, too_late };

/// Waits until the bytes are there, at most until `end`.
Received receive_all(int socket, char* bytes, std::size_t count, const std::optional<Clock::time_point>& end) {
  while (count > 0) {
    if (end) {
      pollfd event{socket, POLLIN, 0};
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - Clock::now()).count();
      const int happened = ::poll(&event, 1, static_cast<int>(std::max<long long>(left, 0)));
      if (happened < 0 && errno == EINTR) continue;  // it was stopped for a while
      if (happened == 0) return Received::too_late;
    }
    const ssize_t got = ::recv(socket, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Received::nothing;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return Received::all;
}

Received receive_message(int socket, std::string& message, const std::optional<Clock::time_point>& end = {}) {
  std::size_t size = 0;
  const Received first = receive_all(socket, reinterpret_cast<char*>(&size), sizeof size, end);
  if (first != Received::all) return first;
  if (size > most_bytes) return Received::nothing;
  message.resize(size);
  return receive_all(socket, message.data(), size, end);
}

// One function for both directions: what is put in is taken out.

template <class Pack, class Values>
void pack_parameter(Pack& pack, Values& parameter) {
  pack(parameter.name), pack(parameter.type), pack(parameter.unit), pack(parameter.help), pack(parameter.choices);
  pack(parameter.initial), pack(parameter.min), pack(parameter.max);
}

template <class Pack, class Entry>
void pack_entry(Pack& pack, Entry& entry) {
  pack(entry.name), pack(entry.family), pack(entry.summary), pack(entry.reference);
}

struct Question {
  std::string projection;
  std::vector<double> values;
  Box scene;
};

template <class Pack, class Words>
void pack_question(Pack& pack, Words& question) {
  pack(question.projection), pack(question.values), pack(question.scene);
}

void pack_table(Packer& pack, const std::vector<ProjectionEntry>& entries) {
  pack(entries.size());
  for (const ProjectionEntry& entry : entries) {
    pack_entry(pack, entry);
    pack(entry.parameters.size());
    for (const Parameter& parameter : entry.parameters) pack_parameter(pack, parameter);
  }
}

std::vector<ProjectionEntry> unpack_table(Unpacker& unpack) {
  std::vector<ProjectionEntry> entries(unpack.count(1));
  for (ProjectionEntry& entry : entries) {
    pack_entry(unpack, entry);
    entry.parameters.resize(unpack.count(1));
    for (Parameter& parameter : entry.parameters) pack_parameter(unpack, parameter);
  }
  return entries;
}

void pack_answer(Packer& pack, const PluginAnswer& answer) {
  pack(answer.view), pack(int{answer.refusal.has_value()}), pack(answer.refusal.value_or(""));
}

PluginAnswer unpack_answer(Unpacker& unpack) {
  PluginAnswer answer{};
  int is_refused = 0;
  std::string sentence;
  unpack(answer.view), unpack(is_refused), unpack(sentence);
  if (is_refused != 0) answer.refusal = sentence;
  return answer;
}

/// A message begins with the reason why there is nothing more in it, empty where there is.
template <class Fill>
Packer message_or_reason(const Fill& fill) {
  try {
    Packer message;
    message(std::string());
    fill(message);
    return message;
  } catch (const Error& error) {
    Packer message;
    message(std::string(error.what()));
    return message;
  }
}

// What follows runs in the process of the plugin.

PluginAnswer answer_to(const std::string& words, const std::vector<ProjectionEntry>& entries) {
  Question question;
  Unpacker unpack(words);
  pack_question(unpack, question);
  for (const ProjectionEntry& entry : entries)
    if (entry.name == question.projection) return entry.ask(question.values, question.scene);
  throw Error(ErrorKind::plugin, "", "is not there any more");
}

/// The plugin prints where messages go, since a drawing may go to standard output; and it crashes as if the program had
/// no handlers of its own.
void take_precautions() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(crash, SIG_DFL);
}

[[noreturn]] void serve(const std::filesystem::path& path, int socket) noexcept {
  take_precautions();
  std::vector<ProjectionEntry> entries;
  bool goes_on = send_message(socket, message_or_reason([&](Packer& message) {
                                entries = read_plugin(path);
                                pack_table(message, entries);
                              }));
  for (std::string words; goes_on && receive_message(socket, words) == Received::all;)
    goes_on = send_message(
        socket, message_or_reason([&](Packer& message) { pack_answer(message, answer_to(words, entries)); }));
  ::_exit(0);  // without the plugin's code at exit
}

// What follows runs in the program.

void kill_and_wait(pid_t child) {
  ::kill(child, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
}

/// The process as the program sees it.
class PluginProcess {
 public:
  PluginProcess(std::filesystem::path path, double seconds) : path_(std::move(path)), seconds_(seconds) {}
  PluginProcess(const PluginProcess&) = delete;
  PluginProcess& operator=(const PluginProcess&) = delete;
  ~PluginProcess() { end(); }

  std::vector<ProjectionEntry> table() {
    const std::lock_guard lock(mutex_);
    return start();
  }
  PluginAnswer ask(const Question& question) {
    const std::lock_guard lock(mutex_);
    if (child_ == 0) start();
    Packer words;
    pack_question(words, question);
    if (!send_message(socket_, words)) refuse(ending());
    const std::string message = reply();
    Unpacker unpack(message);
    expect_no_reason(unpack);
    return unpack_answer(unpack);
  }
  void rest() {
    const std::lock_guard lock(mutex_);
    end();
  }

 private:
  std::vector<ProjectionEntry> start();
  std::string reply();
  std::string ending();
  void end();
  [[noreturn]] static void refuse(const std::string& reason) { throw Error(ErrorKind::plugin, "", reason); }
  static void expect_no_reason(Unpacker& message) {
    std::string reason;
    message(reason);
    if (!reason.empty()) refuse(reason);
  }

  const std::filesystem::path path_;
  const double seconds_;
  std::mutex mutex_;
  pid_t child_ = 0;  ///< 0: there is none
  int socket_ = -1;
};

std::vector<ProjectionEntry> PluginProcess::start() {
  end();
  std::fflush(stdout);
  wait_for_other_loads();
  std::array<int, 2> ends{-1, -1};
  const bool is_connected = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
  const pid_t child = is_connected ? ::fork() : -1;
  if (child == 0) {
    ::close(ends[0]);
    serve(path_, ends[1]);
  }
  if (child < 0) {
    const std::string reason = std::strerror(errno);
    if (is_connected) ::close(ends[0]), ::close(ends[1]);
    refuse("cannot get a process of its own: " + reason);
  }
  ::close(ends[1]);
  child_ = child;
  socket_ = ends[0];
  try {
    const std::string message = reply();
    Unpacker unpack(message);
    expect_no_reason(unpack);
    return unpack_table(unpack);
  } catch (const Error& error) {
    const bool did_something = child_ == 0;
    end();
    refuse(error.what() + std::string(did_something ? " when it is loaded" : ""));
  }
}

std::string PluginProcess::reply() {
  std::string message;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds_));
  const Received received = receive_message(socket_, message, end);
  if (received == Received::all) return message;
  if (received == Received::nothing) refuse(ending());
  this->end();
  refuse("takes more than " + format_number(seconds_) + " s");
}

/// How the process ended that says nothing more.
std::string PluginProcess::ending() {
  ::close(std::exchange(socket_, -1));
  const pid_t child = std::exchange(child_, 0);
  int status = 0;
  pid_t ended = 0;
  // It may have closed the socket and continue.
  for (int wait_ms = 0; ended == 0 && wait_ms < 100; ++wait_ms) {
    ended = ::waitpid(child, &status, WNOHANG);
    if (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (ended == 0) kill_and_wait(child);
  if (ended > 0 && WIFSIGNALED(status)) return std::string("crashes (") + ::strsignal(WTERMSIG(status)) + ")";
  return "ends the program";
}

void PluginProcess::end() {
  if (child_ == 0) return;
  ::close(std::exchange(socket_, -1));
  kill_and_wait(std::exchange(child_, 0));
}

}  // namespace

std::vector<ProjectionEntry> read_plugin_apart(const std::filesystem::path& path, Afterwards afterwards,
                                               double seconds) {
  const auto process = std::make_shared<PluginProcess>(path, seconds);
  std::vector<ProjectionEntry> entries = process->table();
  if (afterwards == Afterwards::rests) process->rest();
  for (ProjectionEntry& entry : entries) {
    entry.plugin = path;
    entry.ask = [process, name = entry.name](const std::vector<double>& values, const Box& scene) {
      return process->ask({name, values, scene});
    };
  }
  return entries;
}

}  // namespace epura::projection
