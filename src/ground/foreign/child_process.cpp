// SPDX-License-Identifier: Apache-2.0
#include "foreign/child_process.hpp"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>
#include <thread>
#include <utility>

#include "base/shared_library.hpp"
#include "base/text.hpp"

namespace epura::foreign {

namespace {

// Returns the status of the process.
int kill_and_wait(pid_t child) {
  ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments, int socket) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, socket, 3);
  // The program prints to where messages go, since standard output may receive a drawing.
  ::posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = 0;
  const int failure = ::posix_spawn(&child, program.c_str(), &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  errno = failure;
  return failure == 0 ? child : -1;
}

// Without exit handlers. An exception must not go on to where the other process waits for the answers of this one,
// which tells that this one ends.
[[noreturn]] void serve_and_exit(const std::function<void(int socket)>& serve, int socket) noexcept {
  try {
    serve(socket);
  } catch (const std::bad_alloc&) {  // there may be no memory even to say so: the other process says how this one ends
    ::_exit(1);
  }
  ::_exit(0);
}

}  // namespace

template <class Start>
void ChildProcess::connect(const Start& start) {
  end();
  std::array<int, 2> ends{-1, -1};
  const bool is_connected = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
  const pid_t child = is_connected ? start(ends) : -1;
  if (child < 0) {
    const std::string reason = std::strerror(errno);
    if (is_connected) ::close(ends[0]), ::close(ends[1]);
    refuse("cannot start a separate process: " + reason);
  }
  ::close(ends[1]);
  child_ = child;
  socket_ = ends[0];
  lacked_memory_ = false;
  incoming_ = {};
}

void ChildProcess::fork(const std::function<void(int socket)>& serve) {
  connect([&](const std::array<int, 2>& ends) {
    std::fflush(stdout);
    wait_for_other_loads();
    const pid_t child = ::fork();
    if (child != 0) return child;
    ::close(ends[0]);
    serve_and_exit(serve, ends[1]);
  });
}

void ChildProcess::run(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  connect([&](const std::array<int, 2>& ends) { return spawn(program, arguments, ends[1]); });
}

void ChildProcess::send(const Packer& message) {
  if (!send_message(socket_, message)) refuse(ending());
}

std::optional<std::string> ChildProcess::receive(Clock::time_point until, std::size_t max_bytes) {
  const Received received = incoming_.receive(socket_, until, max_bytes);
  if (received == Received::nothing) refuse(ending());
  return received == Received::all ? std::optional(incoming_.take()) : std::nullopt;
}

std::string ChildProcess::receive_within(double seconds, std::size_t max_bytes) {
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  if (auto message = receive(until, max_bytes)) return *std::move(message);
  end();
  refuse("takes more than " + format_number(seconds) + " s");
}

double ChildProcess::waited_for_processor() const {
  constexpr double seconds = 1e-9;  // of a nanosecond
  // Of its first thread, which waits for the others where there are any: for how long it ran, and for how long it
  // waited.
  std::ifstream file("/proc/" + std::to_string(child_) + "/schedstat");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string_view> words = split(line, ' ');
  return words.size() < 2 ? 0 : seconds * parse_number(words[1]).value_or(0);
}

/// Returns how a process ended that sends nothing more.
std::string ChildProcess::ending() {
  ::close(std::exchange(socket_, -1));
  const pid_t child = std::exchange(child_, 0);
  int status = 0;
  pid_t ended = 0;
  // The process may have closed the socket and still be running.
  for (int wait_ms = 0; ended == 0 && wait_ms < 100; ++wait_ms) {
    ended = ::waitpid(child, &status, WNOHANG);
    if (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (ended == 0) {
    status = kill_and_wait(child);
    if (WIFEXITED(status)) ended = child;
  }
  lacked_memory_ = ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == no_memory_status;
  if (lacked_memory_) return "has not enough memory";
  if (ended > 0 && WIFSIGNALED(status)) return std::string("crashes (") + ::strsignal(WTERMSIG(status)) + ")";
  return "exits";
}

void ChildProcess::end() {
  if (child_ == 0) return;
  ::close(std::exchange(socket_, -1));
  kill_and_wait(std::exchange(child_, 0));
}

}  // namespace epura::foreign
