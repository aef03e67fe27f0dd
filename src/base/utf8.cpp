#include "base/utf8.hpp"

#include <cstddef>
#include <cstdint>

namespace epura {

namespace {

constexpr char32_t replacement = 0xFFFD;

struct Character {
  std::size_t length;  ///< in bytes
  char32_t code;
};

// What stands at the front of a text; one byte and U+FFFD when that is no character.
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
  if (overlong || surrogate || code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF) return invalid;
  return {length, code};
}

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

}  // namespace epura
