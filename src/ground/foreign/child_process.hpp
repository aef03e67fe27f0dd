// SPDX-License-Identifier: Apache-2.0
// A process for foreign code, and the socket to it. If that code crashes, hangs or exits, this process receives a
// sentence about it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "foreign/messages.hpp"
#include "foreign/parameters.hpp"

namespace epura::foreign {

/// The status with which a process ends for lack of memory.
inline constexpr int no_memory_status = 77;

class ChildProcess {
 public:
  /// Without a process as yet.
  ChildProcess() = default;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess() { end(); }

  /// Starts a copy of this process that only runs `serve` with its end of the socket. Throws Error{plugin}.
  void fork(const std::function<void(int socket)>& serve);
  /// Starts a separate program, whose end of the socket is descriptor 3. Throws Error{plugin}.
  void run(const std::filesystem::path& program, const std::vector<std::string>& arguments);

  [[nodiscard]] bool is_there() const { return child_ != 0; }
  /// The descriptor to poll for messages.
  [[nodiscard]] int socket() const { return socket_; }
  /// Throws Error{plugin} with the way in which the process ended, if it is gone.
  void send(const Packer& message);
  /// Returns nothing if there is no message by `until`. Throws Error{plugin} with the way in which the process ended,
  /// if it is gone.
  std::optional<std::string> receive(Clock::time_point until, std::size_t max_bytes);
  /// The same within a number of seconds. Throws Error{plugin} and kills the process if there is no message by then.
  std::string receive_within(double seconds, std::size_t max_bytes);
  /// Returns what `unpack` extracts from the first message, which is sent when the code is loaded. Throws Error{plugin}
  /// and ends the process if that fails.
  template <class Unpack>
  auto receive_loaded(double seconds, std::size_t max_bytes, const Unpack& unpack);
  /// Seconds for which it was ready to go on, but others had the processors; 0 where the system does not say.
  [[nodiscard]] double waited_for_processor() const;
  /// Whether it ended with `no_memory_status`.
  [[nodiscard]] bool lacked_memory() const { return lacked_memory_; }
  /// Kills the process.
  void end();

 private:
  template <class Start>
  void connect(const Start& start);
  std::string ending();

  pid_t child_ = 0;  ///< 0: there is no process
  int socket_ = -1;
  bool lacked_memory_ = false;
  Incoming incoming_;
};

template <class Unpack>
auto ChildProcess::receive_loaded(double seconds, std::size_t max_bytes, const Unpack& unpack) {
  try {
    const std::string message = receive_within(seconds, max_bytes);
    Unpacker words(message);
    expect_no_reason(words);
    return unpack(words);
  } catch (const Error& error) {
    const bool did_something = !is_there();
    end();
    refuse(error.what() + std::string(did_something ? " while loading" : ""));
  }
}

}  // namespace epura::foreign
