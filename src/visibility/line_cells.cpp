#include "visibility/line_cells.hpp"

#include <algorithm>
#include <cmath>

namespace epura {

namespace {

int clamped(double place, int count) {
  if (!(place > 0)) return 0;
  return place >= count - 1 ? count - 1 : static_cast<int>(place);
}

}  // namespace

int CellGrid::column(double x) const { return clamped((x - origin.x) / side.x, columns); }

int CellGrid::row(double y) const { return clamped((y - origin.y) / side.y, rows); }

CellGrid make_cell_grid(const Vec2& least, const Vec2& most, double items) {
  constexpr double most_cells_across = 4096;
  const Vec2 size = most - least;
  const double longest = std::max(size.x, size.y);
  if (!(longest > 0)) return {least, Vec2(1), 1, 1};
  // A long thin drawing gets its cells along its length.
  const double area = std::max(size.x * size.y, longest * longest / most_cells_across);
  const double side = std::max(std::sqrt(area / std::max(items, 1.0)), longest / most_cells_across);
  return {least, Vec2(side), static_cast<int>(size.x / side) + 1, static_cast<int>(size.y / side) + 1};
}

}  // namespace epura
