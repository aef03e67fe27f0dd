// SPDX-License-Identifier: Apache-2.0
// Makes text from files and command lines valid for XML, JSON, PDF and fonts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace epura {

/// Returns the text with U+FFFD for every noncharacter, such as U+FFFF, and for every byte that is not part of a
/// character.
std::string valid_utf8(std::string_view text);

/// Makes untrusted text safe for display: valid UTF-8, with U+FFFD for characters that move the cursor, change colours
/// or reverse the direction of writing. Line ends and tabs are kept.
std::string printable(std::string_view text);

/// The same, with blanks for line ends and tabs.
std::string one_line(std::string_view text);

/// Returns the characters of a text, replaced in the same way.
std::vector<char32_t> characters(std::string_view text);

/// Returns one character as UTF-8.
std::string utf8(char32_t character);

/// Converts UTF-16 with a byte order mark to UTF-8 and drops the mark of UTF-8; leaves anything else as it is.
std::string without_byte_order_mark(std::string bytes);

}  // namespace epura
