// SPDX-License-Identifier: Apache-2.0
#include "dimensions/exchanges.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "dimensions/costs.hpp"

namespace epura::sheet {

namespace {

bool are_tangled(const PlacedDimension& one, const PlacedDimension& other) {
  return do_cross(one, other) || have_crossing_leaders(one, other);
}

// Keeps it if the sum of both costs falls.
bool exchange(ItemArrangement& placed, std::span<const PlacementItem> items, std::size_t a, std::size_t b) {
  if (!items[a].instead || !items[b].instead || placed.has_guests(a) || placed.has_guests(b)) return false;
  const ItemArrangement::Place of_a = placed.place_of(a), of_b = placed.place_of(b);
  const auto cost = [&] {
    return placed.own_cost(a) + placed.own_cost(b) + placed.cost_around(a) + placed.cost_around(b);
  };
  const double before = cost();
  std::optional<ItemPlacement> there = items[a].instead(*of_b.first), here = items[b].instead(*of_a.first);
  if (!there || !here) return false;
  placed.take(a);
  placed.take(b);
  placed.put(a, *there->drawn(), there->cost);
  placed.put(b, *here->drawn(), here->cost);
  if (cost() < before - cost_of_crossing) return true;
  placed.take(a);
  placed.put_back(b, of_b);
  placed.put_back(a, of_a);
  return false;
}

}  // namespace

bool untangle(ItemArrangement& placed, std::span<const PlacementItem> items, std::size_t first) {
  std::set<std::size_t> moved{first};
  std::vector<std::size_t> next{first};
  while (!next.empty()) {
    const std::size_t one = next.back();
    next.pop_back();
    for (std::size_t other = 0; other < items.size(); ++other) {
      if (other == one || !placed[other] || !are_tangled(*placed[one], *placed[other])) continue;
      if (!exchange(placed, items, one, other)) continue;
      moved.insert(other);
      next = {other, one};
      break;
    }
  }
  check(moved.contains(first), "what is untangled is placed");
  return std::ranges::all_of(moved, [&](std::size_t one) {
    return placed.faults(one) == 0 && std::ranges::none_of(placed.all(), [&](const auto& other) {
             return other && &other != &placed[one] && are_tangled(*placed[one], *other);
           });
  });
}

}  // namespace epura::sheet
