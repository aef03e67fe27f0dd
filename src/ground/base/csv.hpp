// SPDX-License-Identifier: Apache-2.0
// Fields of CSV files, RFC 4180.
#pragma once

#include <string>

namespace epura {

/// The field as it stands in a row: in quotation marks if it holds commas, quotation marks or ends of lines.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace epura
