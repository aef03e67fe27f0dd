// SPDX-License-Identifier: Apache-2.0
// Text, attributes and elements of XML and HTML, with all markup escaped. Control characters, which XML cannot
// represent, become blanks.
#pragma once

#include <string>
#include <string_view>

namespace epura::output {

/// Text of an element or an attribute.
void append_escaped(std::string& text, std::string_view value);
/// ` name="value"`
void append_attribute(std::string& text, std::string_view name, std::string_view value);
/// `<name>value</name>` and a line break.
void append_element(std::string& text, std::string_view name, std::string_view value);

std::string base64(std::string_view bytes);

}  // namespace epura::output
