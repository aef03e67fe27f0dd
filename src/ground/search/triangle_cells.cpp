// SPDX-License-Identifier: Apache-2.0
#include "search/triangle_cells.hpp"

#include <cstddef>
#include <utility>

namespace epura::search {

TriangleOnGrid::TriangleOnGrid(const CellGrid& grid, const std::array<Vec2, 3>& corners, const Vec2& slack)
    : grid_(grid), corners_(corners), slack_(slack) {
  const auto& [a, b, c] = corners;
  const Vec2 min = glm::min(glm::min(a, b), c) - slack;
  const Vec2 max = glm::max(glm::max(a, b), c) + slack;
  const Vec2 end = grid.origin + grid.side * Vec2(grid.columns, grid.rows);
  large_ = max.x - min.x > grid.side.x && max.y - min.y > grid.side.y;
  const bool beside = max.x < grid.origin.x || max.y < grid.origin.y || min.x > end.x || min.y > end.y;
  left_ = grid.column(min.x);
  right_ = beside ? left_ - 1 : grid.column(max.x);
  bottom_ = grid.row(min.y);
  top_ = beside ? bottom_ - 1 : grid.row(max.y);
  if (large_) sides_ = {side_between(a, b), side_between(b, c), side_between(c, a)};
}

// A rectangle in a triangle covers at most half of its area.
bool TriangleOnGrid::may_hold_cells() const {
  const Vec2 u = corners_[1] - corners_[0], v = corners_[2] - corners_[0];
  return large_ && std::abs(cross(u, v)) > 4 * grid_.side.x * grid_.side.y;
}

TriangleOnGrid::Side TriangleOnGrid::side_between(const Vec2& a, const Vec2& b) const {
  const auto& [low, high] = a.y <= b.y ? std::pair(a, b) : std::pair(b, a);
  const bool level = high.y - low.y <= slack_.y;
  return {low, high, level ? HUGE_VAL : (high.x - low.x) / (high.y - low.y)};
}

// For a side that is nearly horizontal, only its ends are known.
TriangleOnGrid::LevelCut TriangleOnGrid::cut_level(double y) const {
  std::array<Interval, 2> crossings;
  std::size_t count = 0;
  for (const Side& side : sides_) {
    if (!(side.low.y <= y && y < side.high.y)) continue;
    const double x = side.low.x + (y - side.low.y) * side.slope;
    crossings[count++] = side.slope == HUGE_VAL
                             ? Interval{std::min(side.low.x, side.high.x), std::max(side.low.x, side.high.x)}
                             : Interval{x, x};
  }
  LevelCut cut;
  if (count < 2) return cut;
  if (crossings[0].from > crossings[1].from) std::swap(crossings[0], crossings[1]);
  cut.inner = {crossings[0].to, crossings[1].from};
  cut.hull = crossings[0];
  cut.hull.add(crossings[1]);
  return cut;
}

RowOfCells TriangleOnGrid::cut_row(int row) const {
  const double bottom = grid_.origin.y + row * grid_.side.y - slack_.y;
  const double top = grid_.origin.y + (row + 1) * grid_.side.y + slack_.y;
  const LevelCut lower = cut_level(bottom);
  const LevelCut upper = cut_level(top);
  Interval touched = lower.hull;
  touched.add(upper.hull);
  for (const Vec2& corner : corners_)
    if (bottom <= corner.y && corner.y <= top) touched.add({corner.x, corner.x});
  RowOfCells cells{row, 1, 0, 1, 0};
  if (!(touched.from <= touched.to)) return cells;
  cells.from = std::max(left_, grid_.column(touched.from - slack_.x));
  cells.to = std::min(right_, grid_.column(touched.to + slack_.x));
  const double inner_from = (std::max(lower.inner.from, upper.inner.from) + slack_.x - grid_.origin.x) / grid_.side.x;
  const double inner_to = (std::min(lower.inner.to, upper.inner.to) - slack_.x - grid_.origin.x) / grid_.side.x - 1;
  if (!(std::ceil(inner_from) <= std::floor(inner_to))) return cells;
  cells.inner_from = static_cast<int>(std::clamp(std::ceil(inner_from), 0.0, static_cast<double>(grid_.columns)));
  cells.inner_to = static_cast<int>(std::clamp(std::floor(inner_to), -1.0, grid_.columns - 1.0));
  return cells;
}

}  // namespace epura::search
