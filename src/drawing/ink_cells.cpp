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
    levels_.push_back({{origin, Vec2(width), count(max.x - origin.x), count(max.y - origin.y)}});
  }
}

void InkCells::add(const Vec2& from, const Vec2& to) {
  const double length = glm::distance(from, to);
  std::size_t level = 0;
  while (level + 1 < levels_.size() && length > cells_a_part * levels_[level].grid.side.x) ++level;
  levels_[level].used = true;
  search::visit_cells(levels_[level].grid, from, to, 0, [&](int cell, double, double) {
    if (2 * taken_ >= slots_.size()) grow();
    const std::uint64_t key = key_of(level, cell);
    Slot& slot = slots_[slot_of(key)];
    if (slot.head < 0) ++taken_;
    const int link = static_cast<int>(links_.size());
    links_.push_back({count_, slot.head});
    slot = {key, link};
  });
  ++count_;
}

std::size_t InkCells::slot_of(std::uint64_t key) const {
  std::uint64_t hash = (key ^ key >> 29) * 0xbf58476d1ce4e5b9;
  hash ^= hash >> 32;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash & mask;
  while (slots_[slot].head >= 0 && slots_[slot].key != key) slot = (slot + 1) & mask;
  return slot;
}

void InkCells::grow() {
  std::vector<Slot> old(2 * slots_.size());
  std::swap(old, slots_);
  for (const Slot& slot : old)
    if (slot.head >= 0) slots_[slot_of(slot.key)] = slot;
}

}  // namespace epura::drawing
