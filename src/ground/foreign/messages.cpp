// SPDX-License-Identifier: Apache-2.0
#include "foreign/messages.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <span>
#include <string_view>
#include <utility>

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

/// Receives bytes until `end` and adds their number to `got`.
Received receive_bytes(int socket, std::span<char> bytes, std::size_t& got,
                       const std::optional<Clock::time_point>& end) {
  while (got < bytes.size()) {
    if (end) {
      pollfd event{socket, POLLIN, 0};
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*end - Clock::now()).count();
      const int happened = ::poll(&event, 1, static_cast<int>(std::max<long long>(left, 0)));
      if (happened < 0 && errno == EINTR) continue;  // it was suspended for a while
      if (happened == 0) return Received::too_late;
    }
    const ssize_t came = ::recv(socket, bytes.data() + got, bytes.size() - got, 0);
    if (came < 0 && errno == EINTR) continue;
    if (came <= 0) return Received::nothing;
    got += static_cast<std::size_t>(came);
  }
  return Received::all;
}

}  // namespace

bool send_message(int socket, const Packer& message) {
  Packer size;
  size(message.bytes().size());
  return send_all(socket, size.bytes()) && send_all(socket, message.bytes());
}

Received Incoming::receive(int socket, const std::optional<Clock::time_point>& end, std::size_t max_bytes) {
  if (got_ < size_.size()) {
    const Received received = receive_bytes(socket, size_, got_, end);
    if (received != Received::all) return received;
    const auto size = std::bit_cast<std::size_t>(size_);
    if (size > max_bytes) return Received::nothing;
    message_.resize(size);
  }
  std::size_t got = got_ - size_.size();
  const Received received = receive_bytes(socket, message_, got, end);
  got_ = size_.size() + got;
  return received;
}

std::string Incoming::take() {
  got_ = 0;
  return std::exchange(message_, {});
}

void expect_no_reason(Unpacker& message) {
  std::string reason;
  message(reason);
  if (!reason.empty()) throw Error(ErrorKind::plugin, "", reason);
}

}  // namespace epura::foreign
