// SPDX-License-Identifier: Apache-2.0
// Finds straight lines from places that lie on them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "search/choose_grid.hpp"

namespace epura::search {

class LinesAt {
 public:
  using Line = std::array<Vec2, 2>;

  LinesAt(std::span<const Line> lines, double margin) : grid_(grid_over(lines, margin)) {
    by_cell_ = Groups<int>(static_cast<std::size_t>(grid_.count()), [&](const auto& add) {
      parallel_for(lines.size(), grain::medium, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          visit_cells(grid_, lines[i][0], lines[i][1], margin,
                      [&](int cell, double, double) { add(static_cast<std::size_t>(cell), static_cast<int>(i)); });
      });
    });
    parallel_for(by_cell_.size(), grain::medium, [&](std::size_t begin, std::size_t end) {
      for (std::size_t cell = begin; cell < end; ++cell) std::sort(by_cell_[cell].begin(), by_cell_[cell].end());
    });
  }

  /// The numbers of all lines within the margin of a place, and of some others near it, ascending.
  [[nodiscard]] std::span<const int> operator()(const Vec2& place) const {
    return in_cell(grid_.cell(grid_.column(place.x), grid_.row(place.y)));
  }
  [[nodiscard]] const CellGrid& grid() const { return grid_; }
  [[nodiscard]] std::span<const int> in_cell(int cell) const { return by_cell_[static_cast<std::size_t>(cell)]; }

 private:
  // Cells hold a few lines each, unless lines are crowded.
  static CellGrid grid_over(std::span<const Line> lines, double margin) {
    constexpr double cells_a_line = 2, cuts_a_line = 8;
    return grid_over_lines(lines, {cells_a_line * static_cast<double>(lines.size()) + 1, 4 * margin, cuts_a_line, 0});
  }

  CellGrid grid_;
  Groups<int> by_cell_{};
};

}  // namespace epura::search
