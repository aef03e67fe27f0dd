// SPDX-License-Identifier: Apache-2.0
#include "output/json_text.hpp"

#include <array>
#include <cmath>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace epura::output {

std::string json_string(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : valid_utf8(text)) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      result += "\\u00";
      result += digits[static_cast<std::size_t>(c) / 16];
      result += digits[static_cast<std::size_t>(c) % 16];
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? format_number(value) : "null"; }

std::string json_vector(const Vec3& v) { return json_list(std::array{v.x, v.y, v.z}, json_number); }

}  // namespace epura::output
