// The cells of a uniform grid that a line passes through.
#pragma once

#include "base/vec.hpp"

namespace epura {

/// Square cells from `origin`, `columns` by `rows` of them; what lies outside belongs to the nearest one.
struct CellGrid {
  Vec2 origin;
  double side;
  int columns, rows;

  [[nodiscard]] int column(double x) const;
  [[nodiscard]] int row(double y) const;
  [[nodiscard]] int cell(int column, int row) const { return row * columns + column; }
};

/// Cells for about `items` things spread over a box.
CellGrid make_cell_grid(const Vec2& least, const Vec2& most, double items);

/// Calls `visit(cell)` for every cell within `margin` of the line a, b (and a few more), each once.
template <class Visit>
void visit_cells(const CellGrid& grid, const Vec2& a, const Vec2& b, double margin, Visit visit) {
  const Vec2 low = a.y <= b.y ? a : b;
  const Vec2 high = a.y <= b.y ? b : a;
  const int last = grid.row(high.y + margin);
  for (int row = grid.row(low.y - margin); row <= last; ++row) {
    // The part of the line in this row, widened; the outermost rows take all that lies beyond them.
    const double from = row == 0 ? -HUGE_VAL : grid.origin.y + row * grid.side - margin;
    const double to = row == grid.rows - 1 ? HUGE_VAL : grid.origin.y + (row + 1) * grid.side + margin;
    const double rise = high.y - low.y;
    const double s0 = rise > 0 && from > low.y ? (from - low.y) / rise : 0;
    const double s1 = rise > 0 && to < high.y ? (to - low.y) / rise : 1;
    const double x0 = low.x + s0 * (high.x - low.x);
    const double x1 = low.x + s1 * (high.x - low.x);
    const double slack = margin + grid.side * 0x1p-20;
    const int end = grid.column((x0 < x1 ? x1 : x0) + slack);
    for (int column = grid.column((x0 < x1 ? x0 : x1) - slack); column <= end; ++column) visit(grid.cell(column, row));
  }
}

}  // namespace epura
