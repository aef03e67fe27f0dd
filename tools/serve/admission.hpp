// SPDX-License-Identifier: Apache-2.0
// Who is answered: only what comes from the page that this process serves, and knows the token in its address.
#pragma once

#include <optional>
#include <string>

#include "serve/http/library.hpp"

namespace epura {

/// Where a server is found.
struct ServedAddress {
  int port;
  std::string token;

  /// "127.0.0.1:8080"
  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(port); }
  [[nodiscard]] std::string url() const { return "http://" + host() + "/" + token + "/"; }
};

/// 128 random bits from the system, in hexadecimal digits. Throws Error{output}.
std::string make_token();

/// Returns why a request is refused; nothing if it is answered. A page of another site may send requests to this
/// address, also by a name of its own that leads here (DNS rebinding): then they name that site in Host or Origin.
std::optional<std::string> reason_to_refuse(const http::Request& request, const ServedAddress& address);

/// What follows the token in the path of a request that is answered: "view".
std::string resource_of(const http::Request& request, const ServedAddress& address);

/// The value of an argument; empty if it is not given.
std::string argument_of(const http::Request& request, const std::string& name);

}  // namespace epura
