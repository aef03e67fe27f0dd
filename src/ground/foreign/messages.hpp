// SPDX-License-Identifier: Apache-2.0
// Messages over a socket between this process and one with foreign code: the length, then the bytes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "foreign/packing.hpp"

namespace epura::foreign {

using Clock = std::chrono::steady_clock;

/// Returns false if the other process is gone.
bool send_message(int socket, const Packer& message);

enum class Received { all, nothing, too_late };

/// A message that is being received, possibly in pieces.
class Incoming {
 public:
  /// Waits until the message is complete, at most until `end`; then call `take`. `nothing`: the other process is gone,
  /// or its message is longer than `max_bytes`, which only happens if it is damaged. After `too_late`, the next call
  /// continues.
  Received receive(int socket, const std::optional<Clock::time_point>& end, std::size_t max_bytes);
  std::string take();

 private:
  std::array<char, sizeof(std::size_t)> size_{};
  std::string message_;
  std::size_t got_ = 0;  ///< bytes received of size and message
};

/// A message begins with the reason why it contains nothing else; the reason is empty if it does.
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

/// Throws Error{plugin} with the reason at the beginning of the message, unless it is empty. Then the contents follow.
void expect_no_reason(Unpacker& message);

}  // namespace epura::foreign
