// SPDX-License-Identifier: Apache-2.0
#include "dimensions/item_arrangement.hpp"

#include <algorithm>
#include <tuple>

#include "base/error.hpp"

namespace epura::sheet {

ItemArrangement::ItemArrangement(std::span<const PlacementItem> items, Obstacles obstacles)
    : guests_(items.size()), obstacles_(std::move(obstacles)), placed_(items.size()), own_(items.size()) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].host) guests_[*items[i].host].push_back(i);
}

void ItemArrangement::put(std::size_t item, PlacedDimension place, double own) {
  check(!placed_[item] && own >= 0, "a place has a cost, and an item one place");
  obstacles_.add(place);
  placed_[item] = std::move(place);
  own_[item] = own;
}

void ItemArrangement::take(std::size_t item) {
  obstacles_.remove(*placed_[item]);
  placed_[item].reset();
  for (const std::size_t guest : guests_[item])
    if (placed_[guest]) take(guest);
}

void ItemArrangement::put_back(const State& before) {
  for (const std::optional<PlacedDimension>& one : placed_)
    if (one) obstacles_.remove(*one);
  std::tie(placed_, own_) = before;
  for (const std::optional<PlacedDimension>& one : placed_)
    if (one) obstacles_.add(*one);
}

void ItemArrangement::put_back(std::size_t item, const Place& before) {
  if (placed_[item]) take(item);
  if (before.first) put(item, *before.first, before.second);
}

bool ItemArrangement::has_guests(std::size_t item) const {
  return std::ranges::any_of(guests_[item], [this](std::size_t guest) { return placed_[guest].has_value(); });
}

double ItemArrangement::cost_around(std::size_t item, double max) {
  obstacles_.remove(*placed_[item]);
  const double cost = obstacles_.cost(*placed_[item], max);
  obstacles_.add(*placed_[item]);
  return cost;
}

int ItemArrangement::crossings(std::size_t item) const {
  int count = 0;
  for (std::size_t i = 0; i < placed_.size(); ++i)
    if (i != item && placed_[i] && do_cross(*placed_[item], *placed_[i])) ++count;
  return count;
}

}  // namespace epura::sheet
