// SPDX-License-Identifier: Apache-2.0
// Tells that there are no lines near a place, at the cost of one bit for a cell of a grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/vec.hpp"
#include "search/line_cells.hpp"

namespace epura::search {

class OccupiedCells {
 public:
  /// Lines should lie in the box; `side` is the least width of a cell.
  OccupiedCells(const Vec2& min, const Vec2& max, double side)
      : grid_(grid_over(min, max, side)), occupied_(static_cast<std::size_t>(grid_.count()), false) {}

  /// Occupies the cells within `margin` of a line.
  void add(const Vec2& from, const Vec2& to, double margin) {
    visit_cells(grid_, from, to, margin, [&](int cell, double, double) { occupied_[cell] = true; });
  }

  /// False only if no line was added within its margin of this place.
  [[nodiscard]] bool may_meet(const Vec2& place) const {
    return occupied_[grid_.cell(grid_.column(place.x), grid_.row(place.y))];
  }
  /// False only if no line was added within its margin of this one.
  [[nodiscard]] bool may_meet(const Vec2& from, const Vec2& to) const {
    bool found = false;
    visit_cells(grid_, from, to, 0, [&](int cell, double, double) { found = found || occupied_[cell]; });
    return found;
  }

 private:
  static constexpr double max_columns = 2048;

  static CellGrid grid_over(const Vec2& min, const Vec2& max, double side) {
    const Vec2 size = glm::max(max - min, Vec2(0));
    const double width = std::max(side, std::max(size.x, size.y) / max_columns);
    return {min, Vec2(width), static_cast<int>(std::ceil(size.x / width)) + 1,
            static_cast<int>(std::ceil(size.y / width)) + 1};
  }

  CellGrid grid_;
  std::vector<bool> occupied_;
};

}  // namespace epura::search
