// SPDX-License-Identifier: Apache-2.0
#include "search/choose_grid.hpp"

#include <cmath>

namespace epura::search {

CellGrid choose_grid(const PageBox& page, const Cuts& lines, const Cuts& areas, const GridLimits& limits) {
  const Vec2 size = glm::max(page.max - page.min, Vec2(limits.side));
  const auto cost = [&](int columns, int rows) {
    if (size.x / columns < limits.side || size.y / rows < limits.side) return HUGE_VAL;
    if (areas.of_areas(columns, rows) > limits.cuts_of_area * static_cast<double>(areas.things)) return HUGE_VAL;
    return lines.of_lines(columns, rows);
  };
  const double allowed = limits.cuts_of_line * static_cast<double>(lines.things);
  CellGrid grid{page.min, size, 1, 1};
  while (2.0 * grid.count() <= limits.cells) {
    const double by_column = cost(2 * grid.columns, grid.rows);
    const double by_row = cost(grid.columns, 2 * grid.rows);
    if (!(std::min(by_column, by_row) <= allowed)) break;
    // If both axes cut equally many lines, cells stay square.
    const bool wide = size.x / grid.columns >= size.y / grid.rows;
    const bool halve_columns = by_column == by_row ? wide : by_column < by_row;
    (halve_columns ? grid.columns : grid.rows) *= 2;
  }
  grid.side = size / Vec2(grid.columns, grid.rows);
  return grid;
}

}  // namespace epura::search
