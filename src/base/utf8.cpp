// SPDX-License-Identifier: Apache-2.0
#include "base/utf8.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace epura {

namespace {

constexpr char32_t replacement = 0xFFFD;

struct Character {
  std::size_t length;  ///< in bytes
  char32_t code;
};

// Unicode, 23.7: U+FDD0 to U+FDEF, and the last two of every plane. Neither XML nor Cairo takes all of them.
bool is_noncharacter(char32_t code) { return (code >= 0xFDD0 && code <= 0xFDEF) || (code & 0xFFFE) == 0xFFFE; }

// What stands at the front of a text: U+FFFD for a noncharacter, and for one byte that is part of nothing.
Character first_character(std::string_view text) {
  constexpr Character invalid{1, replacement};
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return {1, lead};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return invalid;
  char32_t code = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return invalid;
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (overlong || surrogate || code > 0x10FFFF) return invalid;
  return {length, is_noncharacter(code) ? replacement : code};
}

/// C0, DEL and C1 move the cursor and change colours; the others turn the direction of writing, so that a text seems to
/// say something else.
bool steers_terminals(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

bool ends_line_or_column(char32_t code) { return code == '\n' || code == '\t'; }

}  // namespace

std::vector<char32_t> characters(std::string_view text) {
  std::vector<char32_t> found;
  found.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    found.push_back(character.code);
    text.remove_prefix(character.length);
  }
  return found;
}

std::string utf8(char32_t character) {
  const auto last = [character](int shift) { return static_cast<char>(0x80 | (character >> shift & 0x3F)); };
  if (character < 0x80) return {static_cast<char>(character)};
  if (character < 0x800) return {static_cast<char>(0xC0 | character >> 6), last(0)};
  if (character < 0x10000) return {static_cast<char>(0xE0 | character >> 12), last(6), last(0)};
  return {static_cast<char>(0xF0 | character >> 18), last(12), last(6), last(0)};
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  valid.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    valid += character.code == replacement ? utf8(replacement) : text.substr(0, character.length);
    text.remove_prefix(character.length);
  }
  return valid;
}

std::string printable(std::string_view text) {
  std::string shown;
  for (const char32_t code : characters(text))
    shown += utf8(steers_terminals(code) && !ends_line_or_column(code) ? replacement : code);
  return shown;
}

std::string one_line(std::string_view text) {
  std::string line = printable(text);
  std::replace_if(line.begin(), line.end(), ends_line_or_column, ' ');
  return line;
}

}  // namespace epura
