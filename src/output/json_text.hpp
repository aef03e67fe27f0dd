// SPDX-License-Identifier: Apache-2.0
// Strings of JSON (RFC 8259).
#pragma once

#include <string>
#include <string_view>

namespace epura::output {

/// The text as a string of JSON, in quotation marks. Bytes that are no UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

}  // namespace epura::output
