// SPDX-License-Identifier: Apache-2.0
#include "base/colour.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace epura {

std::string hexadecimal(const Colour& colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  if (colour == Colour{}) return "#000";
  std::string text = "#";
  for (const int part : {colour.red, colour.green, colour.blue})
    for (const int digit : {part / 16, part % 16}) text += digits[static_cast<std::size_t>(digit)];
  return text;
}

std::optional<Colour> parse_colour(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 4 && text.size() != 7)) return std::nullopt;
  text.remove_prefix(1);
  const std::size_t digits = text.size() / 3;
  std::array<int, 3> parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const char* const begin = text.data() + i * digits;
    const auto [end, error] = std::from_chars(begin, begin + digits, parts[i], 16);
    if (error != std::errc() || end != begin + digits || *begin == '-') return std::nullopt;
    if (digits == 1) parts[i] *= 17;
  }
  return Colour{parts[0], parts[1], parts[2]};
}

}  // namespace epura
