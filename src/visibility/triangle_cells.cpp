#include "visibility/triangle_cells.hpp"

#include <cstddef>

namespace epura {

namespace {

struct Interval {
  double from = HUGE_VAL, to = -HUGE_VAL;

  void add(const Interval& other) {
    from = std::min(from, other.from);
    to = std::max(to, other.to);
  }
};

// A triangle on one level line: where its border may cross, and what surely lies between.
struct LevelCut {
  Interval hull, inner;
};

// Where a side crosses the level y. Of a side that is nearly level itself, only its ends are known.
Interval crossing(const Vec2& a, const Vec2& b, double y, double flat) {
  if (std::abs(b.y - a.y) <= flat) return {std::min(a.x, b.x), std::max(a.x, b.x)};
  const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
  return {x, x};
}

LevelCut cut_level(const std::array<Vec2, 3>& corners, double y, double flat) {
  std::array<Interval, 2> crossings;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[(i + 1) % 3];
    if ((a.y <= y) != (b.y <= y)) crossings[count++] = crossing(a, b, y, flat);
  }
  LevelCut cut;
  if (count < 2) return cut;
  if (crossings[0].from > crossings[1].from) std::swap(crossings[0], crossings[1]);
  cut.inner = {crossings[0].to, crossings[1].from};
  cut.hull = crossings[0];
  cut.hull.add(crossings[1]);
  return cut;
}

}  // namespace

TriangleOnGrid::TriangleOnGrid(const CellGrid& grid, const std::array<Vec2, 3>& corners, const Vec2& slack)
    : grid_(grid), corners_(corners), slack_(slack) {
  const auto& [a, b, c] = corners;
  const Vec2 least = glm::min(glm::min(a, b), c) - slack;
  const Vec2 most = glm::max(glm::max(a, b), c) + slack;
  const Vec2 end = grid.origin + grid.side * Vec2(grid.columns, grid.rows);
  large_ = most.x - least.x > grid.side.x && most.y - least.y > grid.side.y;
  const bool beside = most.x < grid.origin.x || most.y < grid.origin.y || least.x > end.x || least.y > end.y;
  left_ = grid.column(least.x);
  right_ = beside ? left_ - 1 : grid.column(most.x);
  bottom_ = grid.row(least.y);
  top_ = beside ? bottom_ - 1 : grid.row(most.y);
}

RowOfCells TriangleOnGrid::cut_row(int row) const {
  const double bottom = grid_.origin.y + row * grid_.side.y - slack_.y;
  const double top = grid_.origin.y + (row + 1) * grid_.side.y + slack_.y;
  const LevelCut lower = cut_level(corners_, bottom, slack_.y);
  const LevelCut upper = cut_level(corners_, top, slack_.y);
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

}  // namespace epura
