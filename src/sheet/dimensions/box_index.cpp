// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/box_index.hpp"

#include <algorithm>

namespace epura {

namespace {

constexpr double side = 25;  // mm
// What lies far off the paper belongs to the outermost cells.
constexpr double last_cell = 64;

}  // namespace

BoxIndex::Cell BoxIndex::cell_at(const Vec2& place) {
  const Vec2 cell = glm::clamp(glm::floor(place / side), Vec2(-last_cell), Vec2(last_cell));
  return {static_cast<int>(cell.x), static_cast<int>(cell.y)};
}

template <class Visit>
void BoxIndex::visit_cells(const Cell& least, const Cell& most, const Visit& visit) {
  for (int x = least[0]; x <= most[0]; ++x)
    for (int y = least[1]; y <= most[1]; ++y) visit(Cell{x, y});
}

void BoxIndex::add(std::span<const TurnedBox> boxes) {
  for (const TurnedBox& box : boxes) {
    const std::array key{box.centre.x, box.centre.y, box.along.x, box.along.y, box.half.x, box.half.y};
    const auto [known, is_new] = known_.try_emplace(key, entries_.size());
    if (!is_new) {
      ++entries_[known->second].count;
      continue;
    }
    const auto [least, most] = around(box);
    visit_cells(cell_at(least), cell_at(most), [&](const Cell& cell) { cells_[cell].push_back(entries_.size()); });
    entries_.push_back({box, least, most, 1});
  }
}

int BoxIndex::overlaps(const TurnedBox& box) const {
  const auto [least, most] = around(box);
  int count = 0;
  visit_cells(cell_at(least), cell_at(most), [&, &least = least, &most = most](const Cell& cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const std::size_t i : found->second) {
      const Entry& entry = entries_[i];
      if (entry.least.x > most.x || entry.most.x < least.x || entry.least.y > most.y || entry.most.y < least.y)
        continue;
      // Both may share several cells; that of the lower left corner of what they share counts.
      if (cell_at(glm::max(entry.least, least)) == cell && overlap(entry.box, box)) count += entry.count;
    }
  });
  return count;
}

}  // namespace epura
