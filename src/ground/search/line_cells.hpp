// SPDX-License-Identifier: Apache-2.0
// The cells of a uniform grid that a line crosses.
#pragma once

#include <algorithm>
#include <array>

#include "base/vec.hpp"

namespace epura::search {

/// `columns` by `rows` equal cells from `origin`; positions outside belong to the nearest cell.
struct CellGrid {
  Vec2 origin;
  Vec2 side;  ///< width and height of a cell
  int columns, rows;

  [[nodiscard]] int column(double x) const { return clamped((x - origin.x) / side.x, columns); }
  [[nodiscard]] int row(double y) const { return clamped((y - origin.y) / side.y, rows); }
  [[nodiscard]] int cell(int column, int row) const { return row * columns + column; }
  [[nodiscard]] int count() const { return columns * rows; }
  [[nodiscard]] Vec2 middle(int cell) const { return origin + side * Vec2(cell % columns + 0.5, cell / columns + 0.5); }

 private:
  static int clamped(double place, int count) {
    if (!(place > 0)) return 0;
    return place >= count - 1 ? count - 1 : static_cast<int>(place);
  }
};

/// Returns the parameters (0 at a, 1 at b) between which a line runs through a strip from <= x <= to in one coordinate.
inline std::array<double, 2> part_in_strip(double a, double b, double from, double to) {
  if (a == b) return {0, 1};
  const double s = (from - a) / (b - a);
  const double t = (to - a) / (b - a);
  return {std::max(std::min(s, t), 0.0), std::min(std::max(s, t), 1.0)};
}

/// Calls `visit(cell, from, to)` once for every cell within `margin` of the line a, b, with the parameters of the part
/// that runs through the cell widened by the margin. The outermost cells include what lies beyond them.
template <class Visit>
void visit_cells(const CellGrid& grid, const Vec2& a, const Vec2& b, double margin, Visit visit) {
  const Vec2 slack = margin + grid.side * 0x1p-20;
  const auto strip = [&](int axis, int number, int count) {
    const double from = grid.origin[axis] + number * grid.side[axis];
    return std::array{number == 0 ? -HUGE_VAL : from - slack[axis],
                      number == count - 1 ? HUGE_VAL : from + grid.side[axis] + slack[axis]};
  };
  const int last_row = grid.row(std::max(a.y, b.y) + slack.y);
  for (int row = grid.row(std::min(a.y, b.y) - slack.y); row <= last_row; ++row) {
    const auto [bottom, top] = strip(1, row, grid.rows);
    const auto in_row = part_in_strip(a.y, b.y, bottom, top);
    const double x0 = a.x + in_row[0] * (b.x - a.x);
    const double x1 = a.x + in_row[1] * (b.x - a.x);
    const int last_column = grid.column(std::max(x0, x1) + slack.x);
    for (int column = grid.column(std::min(x0, x1) - slack.x); column <= last_column; ++column) {
      const auto [left, right] = strip(0, column, grid.columns);
      const auto in_column = part_in_strip(a.x, b.x, left, right);
      const double from = std::max(in_row[0], in_column[0]);
      const double to = std::min(in_row[1], in_column[1]);
      if (from <= to) visit(grid.cell(column, row), from, to);
    }
  }
}

}  // namespace epura::search
