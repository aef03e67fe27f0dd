// SPDX-License-Identifier: Apache-2.0
// Where a view shows nothing: outside of all its outlines, even between its parts.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vec.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// Paper that can be reached from beyond a view without crossing a visible line of it, by the cells of a grid.
class BlankPaper {
 public:
  explicit BlankPaper(const drawing::ViewDrawing& drawing);

  [[nodiscard]] bool holds(const Rectangle& box) const;
  /// How often a straight line comes from blank paper to something.
  [[nodiscard]] int entries(const Vec2& from, const Vec2& to) const;

 private:
  [[nodiscard]] int column_of(double x) const;
  [[nodiscard]] int row_of(double y) const;
  [[nodiscard]] std::size_t index(int column, int row) const;
  void mark_lines(const drawing::ViewDrawing& drawing);
  void spread();

  Vec2 corner_;
  double pitch_;
  int columns_, rows_;  ///< the outermost ones are beyond the view
  enum class Cell : unsigned char { shut, line, blank };
  std::vector<Cell> cells_;
};

}  // namespace epura::sheet
