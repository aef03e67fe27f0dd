// SPDX-License-Identifier: Apache-2.0
#include "drawing/ink_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epura::drawing {

namespace {

// So many times as long as a cell is wide is what stands in a grid, at most.
constexpr double cells_a_part = 4;
// Cells of a grid are numbered by ints.
constexpr double most_columns = 1 << 14;

}  // namespace

InkCells::InkCells(const Vec2& min, const Vec2& max, double least) {
  const double extent = std::max(max.x - min.x, max.y - min.y);
  double side = std::max(least, extent / most_columns);
  std::vector<double> sides{side};
  while (side < extent) sides.push_back(side *= 2);
  // What lies elsewhere does not shift the cells.
  const Vec2 origin = glm::floor(min / side) * side;
  for (const double width : sides) {
    const auto count = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / width))); };
    Level level{{origin, Vec2(width), count(max.x - origin.x), count(max.y - origin.y)}, 0, {}};
    level.tile_columns = (level.grid.columns + tile_side - 1) / tile_side;
    levels_.push_back(std::move(level));
  }
}

void InkCells::add(const Vec2& from, const Vec2& to) {
  const double length = glm::distance(from, to);
  std::size_t level = 0;
  while (level + 1 < levels_.size() && length > cells_a_part * levels_[level].grid.side.x) ++level;
  Level& own = levels_[level];
  if (!own.used) own.tiles.assign(tile_of(own, 0, own.grid.rows - 1) + own.tile_columns, none);
  own.used = true;
  visit_cells(own, from, to, 0, [&](int column, int row) {
    int& tile = own.tiles[tile_of(own, column, row)];
    if (tile < 0) {
      tile = static_cast<int>(heads_.size());
      heads_.resize(heads_.size() + tile_side * tile_side, none);
    }
    int& head = heads_[tile + cell_in_tile(column, row)];
    const int link = static_cast<int>(links_.size());
    links_.push_back({count_, head});
    head = link;
  });
  ++count_;
}

}  // namespace epura::drawing
