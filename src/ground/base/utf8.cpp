// SPDX-License-Identifier: Apache-2.0
#include "base/utf8.hpp"

#include <utf8/cpp17.h>
#include <utf8/unchecked.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <iterator>

namespace epura {

namespace {

constexpr char32_t replacement = 0xFFFD;

// Unicode, 23.7: U+FDD0 to U+FDEF, and the last two of every plane. Neither XML nor Cairo accepts all of them.
bool is_noncharacter(char32_t code) { return (code >= 0xFDD0 && code <= 0xFDEF) || (code & 0xFFFE) == 0xFFFE; }

// Calls `visit` for each character, with U+FFFD for a noncharacter and for every byte that is not part of a character.
template <class Visit>
void visit_characters(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::size_t valid = std::min(utf8::find_invalid(text), text.size());
    for (const char *at = text.data(), *end = at + valid; at != end;) {
      const char32_t code = utf8::unchecked::next(at);
      visit(is_noncharacter(code) ? replacement : code);
    }
    if (valid == text.size()) return;
    visit(replacement);
    text.remove_prefix(valid + 1);
  }
}

/// C0, DEL and C1 move the cursor and change colours; the others reverse the direction of writing, so that a text seems
/// to say something else.
bool steers_terminals(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

bool ends_line_or_column(char32_t code) { return code == '\n' || code == '\t'; }

void append(std::string& text, char32_t code) { utf8::unchecked::append(code, std::back_inserter(text)); }

// Converts what follows the byte order mark. Half of a pair becomes the replacement character; an odd byte at the end
// is dropped.
std::string utf8_of_utf16(std::string_view bytes, std::endian order) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
  const auto unit = [&](std::size_t at) -> char32_t {
    return order == std::endian::little ? byte(at) | byte(at + 1) << 8 : byte(at) << 8 | byte(at + 1);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    char32_t code = unit(at);
    const bool high = code >= 0xD800 && code < 0xDC00;
    const char32_t low = high && at + 3 < bytes.size() ? unit(at + 2) : 0;
    if (low >= 0xDC00 && low < 0xE000) {
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      at += 2;
    } else if (code >= 0xD800 && code < 0xE000) {
      code = replacement;
    }
    append(text, code);
  }
  return text;
}

}  // namespace

std::vector<char32_t> characters(std::string_view text) {
  std::vector<char32_t> found;
  found.reserve(text.size());
  visit_characters(text, [&](char32_t code) { found.push_back(code); });
  return found;
}

std::string utf8(char32_t character) {
  std::string text;
  append(text, character);
  return text;
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  valid.reserve(text.size());
  visit_characters(text, [&](char32_t code) { append(valid, code); });
  return valid;
}

std::string printable(std::string_view text) {
  std::string shown;
  visit_characters(text, [&](char32_t code) {
    append(shown, steers_terminals(code) && !ends_line_or_column(code) ? replacement : code);
  });
  return shown;
}

std::string one_line(std::string_view text) {
  std::string line = printable(text);
  std::replace_if(line.begin(), line.end(), ends_line_or_column, ' ');
  return line;
}

std::string without_byte_order_mark(std::string bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) return bytes.substr(3);
  if (bytes.starts_with("\xFF\xFE")) return utf8_of_utf16(bytes, std::endian::little);
  if (bytes.starts_with("\xFE\xFF")) return utf8_of_utf16(bytes, std::endian::big);
  return bytes;
}

}  // namespace epura
