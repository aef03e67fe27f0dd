// SPDX-License-Identifier: Apache-2.0
#include "dimensions/best_places.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "dimensions/costs.hpp"

namespace epura::sheet {

namespace {

// The cheapest placement if it costs less than `best`. They are in ascending order of their cost. What a leader meets,
// all longer ones on its way meet, too.
BestPlacement better_of(std::vector<ItemPlacement>& placements, const Obstacles& obstacles, BestPlacement best) {
  std::vector<double> on_way;
  for (ItemPlacement& placement : placements) {
    if (placement.cost >= best.cost) break;
    if (placement.way && *placement.way >= on_way.size()) on_way.resize(*placement.way + 1);
    if (placement.way && placement.cost + on_way[*placement.way] >= best.cost) continue;
    const auto& drawn = placement.drawn();
    const double cost = placement.cost + obstacles.cost(*drawn, best.cost - placement.cost);
    if (cost < best.cost)
      best = {drawn, cost, placement.cost};
    else if (placement.way && !drawn->leaders.empty())
      on_way[*placement.way] = obstacles.cost_of_way(drawn->leaders.front());
  }
  return best;
}

std::vector<ItemPlacement> in_order(std::vector<ItemPlacement> placements) {
  std::ranges::stable_sort(placements, {}, &ItemPlacement::cost);
  return placements;
}

}  // namespace

BestPlacement BestPlaces::find(std::size_t number, const ItemArrangement& placed) {
  const PlacementItem& item = items_[number];
  const PlacedDimension* host = item.host && placed[*item.host] ? &*placed[*item.host] : nullptr;
  const double max = item.is_clear && !is_crowded ? cost_of_text : cost_in_crowd;
  if (item.host && !host) return {nullptr, max};
  const auto [usual, is_new] = usual_.try_emplace(number);
  if (is_new) usual->second = in_order(item.usual(host));
  BestPlacement best = better_of(usual->second, placed.obstacles(), {nullptr, max});
  if (is_crowded && best.cost >= cost_of_letter && item.in_crowd) {
    const auto [more, is_unknown] = more_.try_emplace(number);
    if (is_unknown) more->second = in_order(item.in_crowd(host));
    best = better_of(more->second, placed.obstacles(), std::move(best));
    if (!keeps_all) more_.erase(more);
  }
  if (best.dimension == nullptr && !usual->second.empty())
    best = {usual->second.front().drawn(), best.cost, usual->second.front().cost, true};
  // Rows are large.
  if (host || (!keeps_all && !item.is_many)) usual_.erase(usual);
  check(best.own >= 0, "a place has a cost");
  return best.dimension == nullptr ? best : elsewhere(item, std::move(best), placed.obstacles());
}

// At equal features, if that is clearly better.
BestPlacement BestPlaces::elsewhere(const PlacementItem& item, BestPlacement best, const Obstacles& obstacles) const {
  for (const PlacementItem::Places& places : item.elsewhere) {
    const double bar = best.cost - cost_of_crossing;
    if (bar <= cost_of_slope) break;  // hardly anything is better
    std::vector<ItemPlacement> there = in_order(places(nullptr));
    if (const BestPlacement better = better_of(there, obstacles, {nullptr, bar}); better.dimension) best = better;
  }
  return best;
}

}  // namespace epura::sheet
