// SPDX-License-Identifier: Apache-2.0
#include "foreign/messages.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <string_view>

namespace epura::foreign {

namespace {

bool send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

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

}  // namespace

bool send_message(int socket, const Packer& message) {
  Packer size;
  size(message.bytes().size());
  return send_all(socket, size.bytes()) && send_all(socket, message.bytes());
}

Received receive_message(int socket, std::string& message, const std::optional<Clock::time_point>& end,
                         std::size_t most_bytes) {
  std::size_t size = 0;
  const Received first = receive_all(socket, reinterpret_cast<char*>(&size), sizeof size, end);
  if (first != Received::all) return first;
  if (size > most_bytes) return Received::nothing;
  message.resize(size);
  // Once a message has begun, it is on its way.
  return receive_all(socket, message.data(), size, end);
}

void expect_no_reason(Unpacker& message) {
  std::string reason;
  message(reason);
  if (!reason.empty()) throw Error(ErrorKind::plugin, "", reason);
}

}  // namespace epura::foreign
