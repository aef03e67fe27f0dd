// SPDX-License-Identifier: Apache-2.0
// Strings, numbers and lists of JSON (RFC 8259).
#pragma once

#include <string>
#include <string_view>

#include "base/vec.hpp"

namespace epura::output {

/// The text as a JSON string, in quotation marks. Invalid UTF-8 becomes U+FFFD.
std::string json_string(std::string_view text);

/// With all necessary digits; null for infinity and NaN, which JSON cannot represent.
std::string json_number(double value);

/// The items, each converted to JSON by `write`, with `separator` between them and `lead` before the first one.
template <class Items, class Write>
std::string json_list(const Items& items, const Write& write, std::string_view separator = ", ",
                      std::string_view lead = "") {
  std::string text = "[";
  bool first = true;
  for (const auto& item : items) {
    text += first ? lead : separator;
    text += write(item);
    first = false;
  }
  return text += ']';
}

/// The same with each item on a separate line; `indent` begins with the line break.
template <class Items, class Write>
std::string json_lines(const Items& items, const Write& write, const std::string& indent) {
  return json_list(items, write, "," + indent, indent);
}

/// [x, y, z]
std::string json_vector(const Vec3& v);

}  // namespace epura::output
