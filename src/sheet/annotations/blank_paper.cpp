// SPDX-License-Identifier: Apache-2.0
#include "annotations/blank_paper.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double finest = 0.5;      // mm, size of a cell
constexpr double most_cells = 500;  // along one side

}  // namespace

BlankPaper::BlankPaper(const drawing::ViewDrawing& drawing) {
  const Vec2 size = drawing.box.max - drawing.box.min;
  pitch_ = std::max(finest, std::max(size.x, size.y) / most_cells);
  corner_ = drawing.box.min - 2 * pitch_;
  columns_ = static_cast<int>(size.x / pitch_) + 5;
  rows_ = static_cast<int>(size.y / pitch_) + 5;
  cells_.assign(index(0, rows_), Cell::shut);
  mark_lines(drawing);
  spread();
}

int BlankPaper::column_of(double x) const {
  return static_cast<int>(std::clamp(std::floor((x - corner_.x) / pitch_), 0.0, columns_ - 1.0));
}

int BlankPaper::row_of(double y) const {
  return static_cast<int>(std::clamp(std::floor((y - corner_.y) / pitch_), 0.0, rows_ - 1.0));
}

std::size_t BlankPaper::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
}

void BlankPaper::mark_lines(const drawing::ViewDrawing& drawing) {
  constexpr double steps_in_cell = 2;
  for (const drawing::Segment& segment : drawing.segments) {
    if (!segment.visible) continue;
    const int steps = static_cast<int>(glm::distance(segment.from, segment.to) / pitch_ * steps_in_cell) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = segment.from + static_cast<double>(i) / steps * (segment.to - segment.from);
      cells_[index(column_of(p.x), row_of(p.y))] = Cell::line;
    }
  }
}

// From a corner, which is beyond the view, to neighbours with a common side.
void BlankPaper::spread() {
  std::vector<std::array<int, 2>> next{{0, 0}};
  cells_.front() = Cell::blank;
  while (!next.empty()) {
    const auto [column, row] = next.back();
    next.pop_back();
    for (const auto& [x, y] : {std::array{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}}) {
      if (x < 0 || y < 0 || x >= columns_ || y >= rows_ || cells_[index(x, y)] != Cell::shut) continue;
      cells_[index(x, y)] = Cell::blank;
      next.push_back({x, y});
    }
  }
  check(cells_.back() == Cell::blank, "around a view there is nothing of it");
}

bool BlankPaper::holds(const Rectangle& box) const {
  for (int row = row_of(box.min.y); row <= row_of(box.max.y); ++row)
    for (int column = column_of(box.min.x); column <= column_of(box.max.x); ++column)
      if (cells_[index(column, row)] != Cell::blank) return false;
  return true;
}

int BlankPaper::entries(const Vec2& from, const Vec2& to) const {
  constexpr double cells_in_step = 2;
  const int steps = static_cast<int>(glm::distance(from, to) / (cells_in_step * pitch_)) + 1;
  int count = 0;
  bool was_blank = false;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = from + static_cast<double>(i) / steps * (to - from);
    const bool is_blank = cells_[index(column_of(p.x), row_of(p.y))] == Cell::blank;
    if (was_blank && !is_blank) ++count;
    was_blank = is_blank;
  }
  return count;
}

}  // namespace epura::sheet
