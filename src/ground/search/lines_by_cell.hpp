// SPDX-License-Identifier: Apache-2.0
// Lines on the page, found by the cells of a grid over them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/groups.hpp"
#include "search/line_cells.hpp"

namespace epura::search {

/// A grid of about as many cells as there are lines, and the lines through each.
class LinesByCell {
 public:
  /// `line(i)` returns the ends of a line, one of `count`. Lines are in all cells within `margin` of them.
  template <class Line>
  LinesByCell(std::size_t count, double margin, const Line& line) {
    constexpr int most = 512;          // columns, and rows
    constexpr double min_side = 1e-9;  // part of the size of coordinates
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (std::size_t i = 0; i < count; ++i) {
      const std::array<Vec2, 2> ends = line(i);
      min = glm::min(min, glm::min(ends[0], ends[1]));
      max = glm::max(max, glm::max(ends[0], ends[1]));
    }
    const int side = std::clamp(static_cast<int>(std::sqrt(count)), 1, most);
    const Vec2 size = glm::max(max - min, Vec2(min_side * std::max(1.0, glm::length(max) + glm::length(min))));
    grid_ = {min, size / static_cast<double>(side), side, side};
    lines_ = Groups<std::size_t>(static_cast<std::size_t>(grid_.count()), [&](const auto& add) {
      for (std::size_t i = 0; i < count; ++i) {
        const std::array<Vec2, 2> ends = line(i);
        visit_cells(grid_, ends[0], ends[1], margin,
                    [&](int cell, double, double) { add(static_cast<std::size_t>(cell), i); });
      }
    });
  }

  [[nodiscard]] const CellGrid& grid() const { return grid_; }
  [[nodiscard]] std::span<const std::size_t> in_cell(int cell) const {
    return std::as_const(lines_)[static_cast<std::size_t>(cell)];
  }
  /// Those through the cell of a place.
  [[nodiscard]] std::span<const std::size_t> at(const Vec2& place) const {
    return in_cell(grid_.cell(grid_.column(place.x), grid_.row(place.y)));
  }

 private:
  CellGrid grid_{};
  Groups<std::size_t> lines_{};
};

}  // namespace epura::search
