// SPDX-License-Identifier: Apache-2.0
// Chooses the size and proportions of the cells into which a part of the page is divided.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "search/line_cells.hpp"

namespace epura::search {

struct PageBox {
  Vec2 min, max;
};

/// How often the lines of a grid cut items: sums over the boxes of the items, as fractions of the page.
struct Cuts {
  std::size_t things = 0;
  Vec2 side{0, 0};
  double area = 0;

  void add(const Vec2& box, const Vec2& page) {
    const Vec2 share = glm::max(box, Vec2(0)) / page;
    ++things;
    side += share;
    area += share.x * share.y;
  }
  /// A line is cut wherever it crosses the grid, an area into as many parts as it covers cells.
  [[nodiscard]] double of_lines(int columns, int rows) const { return side.x * columns + side.y * rows; }
  [[nodiscard]] double of_areas(int columns, int rows) const { return of_lines(columns, rows) + area * columns * rows; }
};

struct GridLimits {
  double cells;         ///< maximum number
  double side;          ///< minimum width and height
  double cuts_of_line;  ///< maximum average
  double cuts_of_area;
};

/// Halves cells along the axis that cuts fewer lines, as often as the limits allow: long parallel lines get long cells.
CellGrid choose_grid(const PageBox& page, const Cuts& lines, const Cuts& areas, const GridLimits& limits);

/// The ends of a line: of an array of two, or of its members `from` and `to`.
inline const std::array<Vec2, 2>& ends_of(const std::array<Vec2, 2>& line) { return line; }
template <class Line>
std::array<Vec2, 2> ends_of(const Line& line) {
  return {line.from, line.to};
}

/// The same for lines.
template <class Lines>
CellGrid grid_over_lines(const Lines& lines, const GridLimits& limits) {
  PageBox page{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const auto& line : lines) {
    const auto [from, to] = ends_of(line);
    page = {glm::min(page.min, glm::min(from, to)), glm::max(page.max, glm::max(from, to))};
  }
  const Vec2 size = glm::max(page.max - page.min, Vec2(limits.side));
  Cuts cuts;
  for (const auto& line : lines) {
    const auto [from, to] = ends_of(line);
    cuts.add(glm::abs(to - from), size);
  }
  return choose_grid(page, cuts, {}, limits);
}

}  // namespace epura::search
