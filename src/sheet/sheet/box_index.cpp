// SPDX-License-Identifier: Apache-2.0
#include "sheet/box_index.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

constexpr double index_cell = 10;  // mm
// Boxes far off the paper belong to the outermost cells.
constexpr double last_cell = 160;

std::array<double, 6> key_of(const TurnedBox& box) {
  return {box.centre.x, box.centre.y, box.along.x, box.along.y, box.half.x, box.half.y};
}

}  // namespace

BoxIndex::Cell BoxIndex::cell_at(const Vec2& place) {
  const Vec2 cell = glm::clamp(glm::floor(place / index_cell), Vec2(-last_cell), Vec2(last_cell));
  return {static_cast<int>(cell.x), static_cast<int>(cell.y)};
}

template <class Visit>
void BoxIndex::visit_cells_of(const Entry& entry, const Visit& visit) {
  const Cell last = cell_at(entry.max);
  for (int x = entry.first[0]; x <= last[0]; ++x)
    for (int y = entry.first[1]; y <= last[1]; ++y) visit(cells_[{x, y}]);
}

void BoxIndex::add(std::span<const TurnedBox> boxes) {
  for (const TurnedBox& box : boxes) {
    const auto [known, is_new] = known_.try_emplace(key_of(box), entries_.size());
    if (is_new) {
      const auto [min, max] = around(box);
      check(min.x <= max.x && min.y <= max.y, "a rectangle contains its box");
      entries_.push_back({box, min, max, cell_at(min), 0});
    }
    const std::size_t number = known->second;
    if (entries_[number].count++ == 0)
      visit_cells_of(entries_[number], [&](std::vector<std::size_t>& cell) { cell.push_back(number); });
  }
}

// Boxes that come and go would otherwise fill the cells, and every search would pass all that were ever there.
void BoxIndex::remove(std::span<const TurnedBox> boxes) {
  for (const TurnedBox& box : boxes) {
    const auto known = known_.find(key_of(box));
    check(known != known_.end() && entries_[known->second].count > 0, "a box that is taken out was added");
    Entry& entry = entries_[known->second];
    if (--entry.count == 0)
      visit_cells_of(entry, [&](std::vector<std::size_t>& cell) { std::erase(cell, known->second); });
  }
}

template <class Visit>
void BoxIndex::visit_near(const TurnedBox& box, const Visit& visit) const {
  const auto [min, max] = around(box);
  check(min.x <= max.x && min.y <= max.y, "a rectangle contains its box");
  const Cell first = cell_at(min), last = cell_at(max);
  for (Cell cell = first; cell[0] <= last[0]; ++cell[0])
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
      const auto found = cells_.find(cell);
      if (found == cells_.end()) continue;
      for (const std::size_t i : found->second) {
        const Entry& entry = entries_[i];
        // Both may share several cells; only the cell with the lower left corner of their intersection counts.
        if (std::max(entry.first[0], first[0]) != cell[0] || std::max(entry.first[1], first[1]) != cell[1]) continue;
        if (entry.min.x > max.x || entry.max.x < min.x || entry.min.y > max.y || entry.max.y < min.y) continue;
        if (!visit(entry)) return;
      }
    }
}

int BoxIndex::overlaps(const TurnedBox& box, double most) const {
  int count = 0;
  visit_near(box, [&](const Entry& entry) {
    count += overlap(entry.box, box) ? entry.count : 0;
    return count <= most;
  });
  return count;
}

int BoxIndex::along(const TurnedBox& line) const {
  int count = 0;
  visit_near(line, [&](const Entry& entry) {
    count += look_parallel(line, entry.box) && overlap(entry.box, line) ? entry.count : 0;
    return true;
  });
  check(count >= 0, "boxes are counted");
  return count;
}

BoxIndex::LinesBeside BoxIndex::beside(const TurnedBox& line, double same, double apart) const {
  TurnedBox wide = line;
  wide.half.y = apart;
  LinesBeside found;
  visit_near(wide, [&](const Entry& entry) {
    const TurnedBox& other = entry.box;
    const bool is_beside = other.half.y == 0 && look_parallel(line, other) && overlap(other, wide);
    const double off = std::abs(cross(line.along, other.centre - line.centre));
    if (is_beside) (off < same ? found.on_it : found.near) += entry.count;
    return true;
  });
  check(found.on_it >= 0 && found.near >= 0, "lines are counted");
  return found;
}

}  // namespace epura::sheet
