// SPDX-License-Identifier: Apache-2.0
// Makes text from files and command lines valid for XML, JSON, PDF and fonts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace epura {

/// The text with U+FFFD for every noncharacter, such as U+FFFF, and for every byte that is part of no character.
std::string valid_utf8(std::string_view text);

/// Untrusted text made safe for display: valid UTF-8, and U+FFFD for what moves the cursor, changes colours or turns
/// the direction of writing. Ends of lines and tabs stay.
std::string printable(std::string_view text);

/// The same, with blanks for ends of lines and tabs.
std::string one_line(std::string_view text);

/// The characters of a text, replaced in the same way.
std::vector<char32_t> characters(std::string_view text);

/// One character as UTF-8.
std::string utf8(char32_t character);

/// UTF-16 with a byte order mark becomes UTF-8, the mark of UTF-8 is dropped, all else stays as it is.
std::string without_byte_order_mark(std::string bytes);

}  // namespace epura
