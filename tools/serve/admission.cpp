// SPDX-License-Identifier: Apache-2.0
#include "serve/admission.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace epura {

namespace {

std::vector<std::string> values_of(const http::Fields& fields, std::string_view name) {
  std::vector<std::string> values;
  for (const auto& [key, value] : fields)
    if (key == name) values.push_back(value);
  return values;
}

// Takes as long for any wrong text of the same length.
bool is_equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  int differences = 0;
  for (std::size_t i = 0; i < a.size(); ++i) differences |= a[i] ^ b[i];
  return differences == 0;
}

}  // namespace

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw Error(ErrorKind::output, "serve", "the system gives no random numbers");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string token;
  for (const unsigned char byte : bytes) {
    token += digits[byte / 16];
    token += digits[byte % 16];
  }
  return token;
}

std::optional<std::string> reason_to_refuse(const http::Request& request, const ServedAddress& address) {
  if (values_of(request.headers, "host") != std::vector{address.host()})
    return "only http://" + address.host() + " is served";
  for (const std::string& origin : values_of(request.headers, "origin"))
    if (origin != "http://" + address.host()) return "pages of other sites are not served";
  // "none": an address that the user typed or opened.
  for (const std::string& site : values_of(request.headers, "sec-fetch-site"))
    if (site != "same-origin" && site != "none") return "pages of other sites are not served";
  const std::string_view path = request.path;
  const std::size_t length = address.token.size();
  const bool has_token = path.size() > length + 1 && path.front() == '/' && path[length + 1] == '/' &&
                         is_equal(path.substr(1, length), address.token);
  if (!has_token) return "the address lacks the token that 'epura serve' printed";
  return std::nullopt;
}

std::string resource_of(const http::Request& request, const ServedAddress& address) {
  return request.path.substr(address.token.size() + 2);
}

std::string argument_of(const http::Request& request, const std::string& name) {
  const std::vector<std::string> values = values_of(request.arguments, name);
  return values.empty() ? "" : values.front();
}

}  // namespace epura
