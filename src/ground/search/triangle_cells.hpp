// SPDX-License-Identifier: Apache-2.0
// The cells of a uniform grid that a triangle touches, and those entirely inside it, row by row.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.hpp"
#include "search/line_cells.hpp"

namespace epura::search {

/// Columns `from` to `to` of a row may be touched; `inner_from` to `inner_to` lie inside the triangle. Either may be
/// empty (from > to).
struct RowOfCells {
  int row;
  int from, to;
  int inner_from, inner_to;
};

/// A triangle on a grid. Cells are widened by `slack` on all sides before they are compared with it: cells that are not
/// reported are certainly not touched, and those reported as inside certainly are inside.
class TriangleOnGrid {
 public:
  TriangleOnGrid(const CellGrid& grid, const std::array<Vec2, 3>& corners, const Vec2& slack);

  /// Whether any cell can lie inside.
  [[nodiscard]] bool may_hold_cells() const;

  /// Calls `visit(RowOfCells)` for every row of the grid that meets the triangle's box.
  template <class Visit>
  void visit_rows(Visit visit) const {
    for (int row = bottom_; row <= top_; ++row) visit(large_ ? cut_row(row) : RowOfCells{row, left_, right_, 1, 0});
  }

 private:
  // A side, from its lower end to its upper end.
  struct Side {
    Vec2 low, high;
    double slope;  ///< of x over y; not finite if the side is nearly horizontal
  };
  struct Interval {
    double from = HUGE_VAL, to = -HUGE_VAL;

    void add(const Interval& other) {
      from = std::min(from, other.from);
      to = std::max(to, other.to);
    }
  };
  // The triangle on one horizontal line: where its border may cross, and the part that certainly lies inside.
  struct LevelCut {
    Interval hull, inner;
  };

  [[nodiscard]] Side side_between(const Vec2& a, const Vec2& b) const;
  [[nodiscard]] LevelCut cut_level(double y) const;
  [[nodiscard]] RowOfCells cut_row(int row) const;

  const CellGrid& grid_;
  std::array<Vec2, 3> corners_;
  std::array<Side, 3> sides_;  ///< set for large triangles only
  Vec2 slack_;
  bool large_;                       ///< wider and higher than a cell
  int left_, right_, bottom_, top_;  ///< cells of its box; right < left if it lies outside the grid
};

}  // namespace epura::search
