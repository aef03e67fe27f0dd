// SPDX-License-Identifier: Apache-2.0
#include "sheet/paper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::sheet {

namespace {

// Trimmed, A0 to A4, longer side first.
constexpr std::array<std::array<double, 2>, 5> a_sizes = {
    {{1189, 841}, {841, 594}, {594, 420}, {420, 297}, {297, 210}}};

// Rounded once: 17 inches are 431.8 mm.
constexpr double in_mm(double inches) { return inches * 254 / 10; }
constexpr AnsiSheet ansi(double longer, double shorter, const Vec2& margins, int long_zones, int short_zones) {
  return {in_mm(longer), in_mm(shorter), in_mm(margins.x), in_mm(margins.y), long_zones, short_zones};
}

// A to E. Fields are 4.25 or 5.5 inches long; A has none.
constexpr std::array<AnsiSheet, 5> ansi_sizes = {{ansi(11, 8.5, {0.25, 0.38}, 0, 0), ansi(17, 11, {0.62, 0.38}, 4, 2),
                                                  ansi(22, 17, {0.5, 0.75}, 4, 4), ansi(34, 22, {1, 0.5}, 8, 4),
                                                  ansi(44, 34, {0.5, 1}, 8, 8)}};

Vec2 area(const Paper& paper) { return drawing_area(paper).size(); }

// The largest factor at which `ink` fits into `room`. A point fits at any factor and keeps its size.
double fitting_scale(const Vec2& ink, const Vec2& room) {
  const double factor = std::min(room.x / ink.x, room.y / ink.y);
  return std::isfinite(factor) ? factor : 1;
}

}  // namespace

Paper make_paper(const scene::PaperChoice& size, bool portrait) {
  switch (size.kind) {
    case scene::PaperChoice::Kind::iso: {
      check(size.number >= 0 && static_cast<std::size_t>(size.number) < a_sizes.size(),
            "a size of paper is in its table");
      const auto& [longer, shorter] = a_sizes[static_cast<std::size_t>(size.number)];
      return portrait ? Paper{shorter, longer, 20, 10} : Paper{longer, shorter, 20, 10};
    }
    case scene::PaperChoice::Kind::ansi: {
      const AnsiSheet& sheet = ansi_sizes[static_cast<std::size_t>(size.number)];
      if (portrait) return {sheet.shorter, sheet.longer, sheet.along_sides, sheet.along_sides, sheet.at_ends};
      return {sheet.longer, sheet.shorter, sheet.at_ends, sheet.at_ends, sheet.along_sides};
    }
    case scene::PaperChoice::Kind::custom: {
      const auto [width, height] = size.size;
      const double margin = std::min(5.0, std::min(width, height) / 10);
      return {width, height, margin, margin};
    }
    case scene::PaperChoice::Kind::none:
    case scene::PaperChoice::Kind::automatic:
    case scene::PaperChoice::Kind::automatic_ansi:
      break;
  }
  return {};
}

scene::PaperChoice paper_of_size(const Vec2& size) {
  constexpr double same = 0.1;
  const double longer = std::max(size.x, size.y), shorter = std::min(size.x, size.y);
  for (std::size_t i = 0; i < a_sizes.size(); ++i)
    if (std::abs(a_sizes[i][0] - longer) < same && std::abs(a_sizes[i][1] - shorter) < same)
      return {scene::PaperChoice::Kind::iso, static_cast<int>(i), {0, 0}};
  return {scene::PaperChoice::Kind::custom, 0, {size.x, size.y}};
}

const AnsiSheet* ansi_sheet(const Paper& paper) {
  if (!paper.ends) return nullptr;
  const double longer = std::max(paper.width, paper.height), shorter = std::min(paper.width, paper.height);
  const auto* const found = std::find_if(ansi_sizes.begin(), ansi_sizes.end(), [&](const AnsiSheet& sheet) {
    return sheet.longer == longer && sheet.shorter == shorter;
  });
  return found == ansi_sizes.end() ? nullptr : found;
}

std::string size_name(const scene::PaperChoice& size) {
  switch (size.kind) {
    case scene::PaperChoice::Kind::iso:
      return "A" + std::to_string(size.number);
    case scene::PaperChoice::Kind::ansi:
      return {static_cast<char>('A' + size.number)};
    case scene::PaperChoice::Kind::custom:
      return format_number(size.size[0]) + "x" + format_number(size.size[1]);
    case scene::PaperChoice::Kind::none:
    case scene::PaperChoice::Kind::automatic:
    case scene::PaperChoice::Kind::automatic_ansi:
      break;
  }
  return "none";
}

std::string paper_name(const Paper& paper) {
  if (paper.width == 0) return {};
  const double longer = std::max(paper.width, paper.height), shorter = std::min(paper.width, paper.height);
  for (std::size_t i = 0; i < a_sizes.size(); ++i)
    if (a_sizes[i][0] == longer && a_sizes[i][1] == shorter) return "A" + std::to_string(i);
  return format_number(paper.width) + "x" + format_number(paper.height);
}

Rectangle drawing_area(const Paper& paper) {
  if (paper.area) return *paper.area;
  const Vec2 corner(paper.left, paper.above());
  return {corner, corner + Vec2(paper.width - paper.left - paper.other, paper.height - 2 * paper.above())};
}

void check_drawing_size(const Vec2& size) {
  if (!(size.x <= scene::longest_side && size.y <= scene::longest_side))
    throw Error(ErrorKind::input, "--scale",
                "the drawing would be " + format_fixed(std::max(size.x, size.y) / 1000, 1) + " m long",
                "use fit or a smaller scale, and points that are on the models");
}

Placement place_ink(const Vec2& min, const Vec2& max, std::optional<double> scale, const Paper& paper) {
  const bool cut = paper.width == 0;
  const Vec2 room = area(cut ? make_paper({}, false) : paper);
  const Vec2 ink = max - min;
  Placement placement{paper, scale ? *scale : fitting_scale(ink, room), {0, 0}, true};
  const Vec2 size = ink * placement.scale;
  check_drawing_size(size);

  Paper& page = placement.paper;
  if (cut) {
    page.width = size.x + page.left + page.other;
    page.height = size.y + 2 * page.above();
  }
  const Vec2 middle = drawing_area(page).min + area(page) / 2.0;
  check(page.width >= 0 && page.height >= 0, "paper has a size");
  placement.shift = middle - (min / 2.0 + max / 2.0) * placement.scale;
  // A fitted drawing may exceed the margin by a rounding error.
  const Vec2 slack = area(page) * (1 + 1e-9) - size;
  placement.inside = slack.x >= 0 && slack.y >= 0;
  return placement;
}

}  // namespace epura::sheet
