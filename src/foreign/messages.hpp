// SPDX-License-Identifier: Apache-2.0
// Messages between this process and one of foreign code, over a socket: each is its length, then its bytes.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

#include "foreign/packing.hpp"

namespace epura::foreign {

using Clock = std::chrono::steady_clock;

/// False where the other process is gone.
bool send_message(int socket, const Packer& message);

enum class Received { all, nothing, too_late };

/// A message on its way, which may come in pieces.
class Incoming {
 public:
  /// Waits until the message is there, at most until `end`; then `take` it. `nothing`: the other process is gone, or
  /// sends what is longer than `most_bytes`, which only damage explains. Where it is too late, the next call goes on.
  Received receive(int socket, const std::optional<Clock::time_point>& end, std::size_t most_bytes);
  std::string take();

 private:
  std::array<char, sizeof(std::size_t)> size_{};
  std::string message_;
  std::size_t got_ = 0;  ///< of both
};

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

/// What the message holds is there once its reason is: empty where nothing failed. Throws Error{plugin} with the
/// reason.
void expect_no_reason(Unpacker& message);

}  // namespace epura::foreign
