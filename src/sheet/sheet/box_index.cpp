// SPDX-License-Identifier: Apache-2.0
#include "sheet/box_index.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

constexpr double index_cell = 10;  // mm
// Boxes far off the paper belong to the outermost cells.
constexpr int last_cell = 160;
constexpr double slack = 1e-6;  // mm, by which boxes that touch may miss each other by rounding

std::array<double, 6> key_of(const TurnedBox& box) {
  return {box.centre.x, box.centre.y, box.along.x, box.along.y, box.half.x, box.half.y};
}

}  // namespace

BoxIndex::Cell BoxIndex::cell_at(const Vec2& place) {
  const Vec2 cell = glm::clamp(glm::floor(place / index_cell), Vec2(-last_cell), Vec2(last_cell));
  return {static_cast<int>(cell.x), static_cast<int>(cell.y)};
}

int BoxIndex::number_of(const Cell& cell) { return cell[0] * (2 * last_cell + 1) + cell[1]; }

// A slanting line passes few of the cells that its rectangle meets.
template <class Visit>
void BoxIndex::visit_cells_of(const TurnedBox& box, const Visit& visit) {
  const auto [min, max] = around(box);
  check(min.x <= max.x && min.y <= max.y, "a rectangle contains its box");
  const Cell first = cell_at(min), last = cell_at(max);
  constexpr double level = 1e-3;  // of a unit vector, along a column
  const bool is_steep = std::abs(box.along.x) < level;
  const double slope = is_steep ? 0 : box.along.y / box.along.x, reach = box.half.y * std::hypot(1, slope) + slack;
  for (int x = first[0]; x <= last[0]; ++x) {
    // In the column, of which the outermost ones have no end.
    const double left = x == first[0] ? min.x : index_cell * x, right = x == last[0] ? max.x : index_cell * (x + 1);
    const auto [low, high] = std::minmax({slope * (left - box.centre.x), slope * (right - box.centre.x)});
    const int bottom = is_steep ? first[1] : cell_at({left, box.centre.y + low - reach})[1],
              top = is_steep ? last[1] : cell_at({left, box.centre.y + high + reach})[1];
    for (int y = std::max(bottom, first[1]); y <= std::min(top, last[1]); ++y)
      if (!visit(number_of({x, y}))) return;
  }
}

void BoxIndex::add(std::span<const TurnedBox> boxes) {
  for (const TurnedBox& box : boxes) {
    const auto [known, is_new] = known_.try_emplace(key_of(box), entries_.size());
    if (is_new) {
      const auto [min, max] = around(box);
      entries_.push_back({box, min, max, 0});
    }
    const std::size_t number = known->second;
    if (entries_[number].count++ == 0)
      visit_cells_of(box, [&](int cell) {
        cells_[cell].push_back(number);
        return true;
      });
  }
}

// Boxes that come and go would otherwise fill the cells, and every search would pass all that were ever there.
void BoxIndex::remove(std::span<const TurnedBox> boxes) {
  for (const TurnedBox& box : boxes) {
    const auto known = known_.find(key_of(box));
    check(known != known_.end() && entries_[known->second].count > 0, "a box that is taken out was added");
    Entry& entry = entries_[known->second];
    if (--entry.count == 0)
      visit_cells_of(box, [&](int cell) {
        std::erase(cells_[cell], known->second);
        return true;
      });
  }
}

template <class Visit>
void BoxIndex::visit_near(const TurnedBox& box, const Visit& visit) const {
  const auto [min, max] = around(box);
  std::vector<std::size_t> seen;  // both may share several cells
  visit_cells_of(box, [&, min = min, max = max](int cell) {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return true;
    for (const std::size_t i : found->second) {
      const Entry& entry = entries_[i];
      if (entry.min.x > max.x || entry.max.x < min.x || entry.min.y > max.y || entry.max.y < min.y) continue;
      if (std::ranges::find(seen, i) != seen.end()) continue;
      seen.push_back(i);
      if (!visit(entry)) return false;
    }
    return true;
  });
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
