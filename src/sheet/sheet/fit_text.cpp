// SPDX-License-Identifier: Apache-2.0
#include "sheet/fit_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/utf8.hpp"

namespace epura::sheet {

namespace {

constexpr std::array<double, 8> standard_heights = {20, 14, 10, 7, 5, 3.5, 2.5, 1.8};
constexpr std::string_view ellipsis = "...";

std::string in_one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool space = (c >= 0 && c <= ' ') || c == 127;
    if (!space)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

// Bytes of the longest prefix, in whole UTF-8 characters, that fits when followed by `end`.
std::size_t fitting_bytes(std::string_view text, std::string_view end, double width, double height,
                          const Lettering& lettering) {
  std::size_t fits = 0, too_long = text.size() + 1;
  // Widths of very long texts are not needed.
  for (std::size_t size = 64; size < text.size(); size *= 2) {
    while (size < text.size() && !begins_character(text[size])) ++size;
    if (lettering.width(text.substr(0, size), height) <= width) continue;
    too_long = std::min(size + 1, too_long);
    break;
  }
  while (true) {
    std::size_t middle = (fits + too_long) / 2;
    while (middle > fits && middle < text.size() && !begins_character(text[middle])) --middle;
    if (middle == fits) middle = fits + 1;
    while (middle < text.size() && !begins_character(text[middle])) ++middle;
    if (middle >= too_long) return fits;
    const std::string tried = std::string(text.substr(0, middle)) + std::string(end);
    (lettering.width(tried, height) <= width ? fits : too_long) = middle;
  }
}

std::pair<std::string, bool> cut_to(std::string_view text, double width, double height, const Lettering& lettering) {
  if (lettering.width(text, height) <= width) return {std::string(text), false};
  std::string_view kept = text.substr(0, fitting_bytes(text, ellipsis, width, height, lettering));
  check(kept.size() <= text.size(), "a text that is cut is not longer");
  while (kept.ends_with(' ')) kept.remove_suffix(1);
  return {std::string(kept) + std::string(ellipsis), true};
}

FittedText in_two_lines(std::string_view text, double width, double height, const Lettering& lettering) {
  // One byte more, so that a space there counts.
  const std::size_t fitting = fitting_bytes(text, {}, width, height, lettering);
  const std::size_t space = text.substr(0, fitting + 1).rfind(' ');
  if (space == std::string_view::npos) {
    const auto [line, cut] = cut_to(text, width, height, lettering);
    return {{line}, height, cut};
  }
  const auto [second, cut] = cut_to(text.substr(space + 1), width, height, lettering);
  return {{std::string(text.substr(0, space)), second}, height, cut};
}

// A line of at most `width`: up to the last sign after which a number may be broken in its second half, or else up to
// the last character that fits.
std::string_view first_line(std::string_view text, double width, double height, const Lettering& lettering) {
  const std::size_t fitting = fitting_bytes(text, {}, width, height, lettering);
  if (fitting >= text.size()) return text;
  const std::size_t sign = text.substr(0, fitting).find_last_of(" -/._");
  if (sign != std::string_view::npos && sign >= fitting / 2) return text.substr(0, sign + 1);
  std::size_t end = std::max<std::size_t>(fitting, 1);
  while (end < text.size() && !begins_character(text[end])) ++end;
  return text.substr(0, end);
}

std::vector<std::string> broken(std::string_view text, double width, double height, const Lettering& lettering) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string_view line = first_line(text, width, height, lettering);
    lines.emplace_back(line);
    text.remove_prefix(line.size());
  }
  return lines;
}

}  // namespace

FittedText fit_whole_text(std::string_view text, const Vec2& room, double height, const Lettering& lettering) {
  const FittedText fitted = fit_text(text, room.x, height, lettering);
  if (fitted.lines.size() < 2 && !fitted.cut) return fitted;
  const std::string line = in_one_line(valid_utf8(text));
  constexpr double smaller = 0.9;
  for (double h = standard_heights.back();; h *= smaller) {
    std::vector<std::string> lines = broken(line, room.x, h, lettering);
    const bool is_narrow = std::all_of(lines.begin(), lines.end(),
                                       [&](const std::string& one) { return lettering.width(one, h) <= room.x; });
    if (is_narrow && static_cast<double>(lines.size()) * line_spacing * h <= room.y)
      return {std::move(lines), h, false};
  }
}

FittedText fit_text(std::string_view text, double width, double height, const Lettering& lettering) {
  const std::string line = in_one_line(valid_utf8(text));
  if (line.empty()) return {{}, height, false};
  const double min_width = lettering.width(line, standard_heights.back());
  for (const double h : standard_heights)
    if (min_width < 1.001 * width && h <= height && lettering.width(line, h) <= width) return {{line}, h, false};
  return in_two_lines(line, width, standard_heights.back(), lettering);
}

}  // namespace epura::sheet
