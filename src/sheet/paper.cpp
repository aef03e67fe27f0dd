// SPDX-License-Identifier: Apache-2.0
#include "sheet/paper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

// Trimmed, A0 to A4, longer side first.
constexpr std::array<std::array<double, 2>, 5> a_sizes = {
    {{1189, 841}, {841, 594}, {594, 420}, {420, 297}, {297, 210}}};

[[noreturn]] void refuse_paper(std::string_view text, const std::string& where) {
  throw Error(Trouble::input, where, "'" + std::string(text) + "' is no paper size",
              "write none, A0 to A4, or width x height in mm such as 300x200");
}

Paper custom_paper(std::string_view text, const std::string& where) {
  const auto parts = split(text, 'x');
  if (parts.size() != 2) refuse_paper(text, where);
  const auto width = parse_number(parts[0]), height = parse_number(parts[1]);
  if (!width || !height) refuse_paper(text, where);
  const auto usable = [](double side) { return side >= 1 && side <= longest_side; };
  if (!usable(*width) || !usable(*height))
    throw Error(Trouble::input, where, "'" + std::string(text) + "' is no usable paper size",
                "sides may be 1 to " + format_number(longest_side) + " mm long");
  const double margin = std::min(5.0, std::min(*width, *height) / 10);
  return {*width, *height, margin, margin};
}

Vec2 area(const Paper& paper) { return {paper.width - paper.left - paper.other, paper.height - 2 * paper.other}; }

// The largest factor that brings `ink` into `room`. A point fits at any factor: it keeps its size.
double fitting_scale(const Vec2& ink, const Vec2& room) {
  const double factor = std::min(room.x / ink.x, room.y / ink.y);
  return std::isfinite(factor) ? factor : 1;
}

}  // namespace

Paper parse_paper(std::string_view text, bool portrait, const std::string& where) {
  const std::string lower = to_lower(text);
  if (lower == "none") return {};
  if (lower.size() == 2 && lower[0] == 'a' && lower[1] >= '0' && lower[1] <= '4') {
    const auto& [longer, shorter] = a_sizes[static_cast<std::size_t>(lower[1] - '0')];
    return portrait ? Paper{shorter, longer, 20, 10} : Paper{longer, shorter, 20, 10};
  }
  return custom_paper(lower, where);
}

std::optional<double> parse_scale(std::string_view text, const std::string& where) {
  if (to_lower(text) == "fit") return std::nullopt;
  const auto parts = split(text, ':');
  const auto paper = parse_number(parts[0]);
  const auto model = parts.size() == 2 ? parse_number(parts[1]) : std::optional<double>(1);
  const double scale = paper && model && parts.size() <= 2 ? *paper / *model : 0;
  if (!std::isfinite(scale) || !(scale > 0) || !(*paper > 0) || std::isinf(*model))
    throw Error(Trouble::input, where, "'" + std::string(text) + "' is no scale",
                "write fit, paper:model such as 1:2 or 5:1, or a number above 0");
  return scale;
}

std::string paper_name(const Paper& paper) {
  if (paper.width == 0) return {};
  const double longer = std::max(paper.width, paper.height), shorter = std::min(paper.width, paper.height);
  for (std::size_t i = 0; i < a_sizes.size(); ++i)
    if (a_sizes[i][0] == longer && a_sizes[i][1] == shorter) return "A" + std::to_string(i);
  return format_number(paper.width) + "x" + format_number(paper.height);
}

Rectangle drawing_area(const Paper& paper) {
  const Vec2 corner(paper.left, paper.other);
  return {corner, corner + area(paper)};
}

void check_drawing_size(const Vec2& size) {
  if (!(size.x <= longest_side && size.y <= longest_side))
    throw Error(Trouble::input, "--scale",
                "the drawing would be " + format_fixed(std::max(size.x, size.y) / 1000, 1) + " m long",
                "use fit or a smaller scale");
}

Placement place_ink(const Vec2& least, const Vec2& most, std::optional<double> scale, const Paper& paper) {
  const bool cut = paper.width == 0;
  const Vec2 room = area(cut ? parse_paper("A4", false) : paper);
  const Vec2 ink = most - least;
  Placement placement{paper, scale ? *scale : fitting_scale(ink, room), {0, 0}, true};
  const Vec2 size = ink * placement.scale;
  check_drawing_size(size);

  Paper& page = placement.paper;
  if (cut) {
    page.width = size.x + page.left + page.other;
    page.height = size.y + 2 * page.other;
  }
  const Vec2 middle = Vec2(page.left, page.other) + area(page) / 2.0;
  placement.shift = middle - (least / 2.0 + most / 2.0) * placement.scale;
  // A fitted drawing may pass the margin by a rounding error.
  const Vec2 slack = area(page) * (1 + 1e-9) - size;
  placement.inside = slack.x >= 0 && slack.y >= 0;
  return placement;
}

}  // namespace epura
