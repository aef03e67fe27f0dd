// SPDX-License-Identifier: Apache-2.0
// Chooses how finely, and in which proportion, a part of the page is divided into cells.
#pragma once

#include <cmath>
#include <cstddef>

#include "search/line_cells.hpp"

namespace epura::search {

struct PageBox {
  Vec2 min, max;
};

/// How often the lines of a grid cut things: sums over their boxes, as shares of the page's.
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
  /// Lines are cut where they cross the grid, areas into as many parts as they cover cells.
  [[nodiscard]] double of_lines(int columns, int rows) const { return side.x * columns + side.y * rows; }
  [[nodiscard]] double of_areas(int columns, int rows) const { return of_lines(columns, rows) + area * columns * rows; }
};

struct GridLimits {
  double cells;         ///< maximum number
  double side;          ///< at least so wide and high
  double cuts_of_line;  ///< at most, on average
  double cuts_of_area;
};

/// Cells are halved along the one or the other axis, whichever cuts fewer lines, as far as the limits allow: long
/// parallel lines get long cells.
CellGrid choose_grid(const PageBox& page, const Cuts& lines, const Cuts& areas, const GridLimits& limits);

/// The same over lines that run from `from` to `to`.
template <class Lines>
CellGrid grid_over_lines(const Lines& lines, const GridLimits& limits) {
  PageBox page{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const auto& line : lines)
    page = {glm::min(page.min, glm::min(line.from, line.to)), glm::max(page.max, glm::max(line.from, line.to))};
  const Vec2 size = glm::max(page.max - page.min, Vec2(limits.side));
  Cuts cuts;
  for (const auto& line : lines) cuts.add(glm::abs(line.to - line.from), size);
  return choose_grid(page, cuts, {}, limits);
}

}  // namespace epura::search
