// SPDX-License-Identifier: Apache-2.0
#include "dimensions/place_items.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "dimensions/best_places.hpp"
#include "dimensions/costs.hpp"
#include "dimensions/exchanges.hpp"
#include "dimensions/item_arrangement.hpp"

namespace epura::sheet {

namespace {

/// How many items have no place: of two arrangements, the one with fewer of what is required is better.
struct Missing {
  std::size_t required = 0, all = 0;
  auto operator<=>(const Missing&) const = default;
};

// Until none of those that may be left out has conflicts.
void take_out_crossed(ItemArrangement& placed, std::span<const PlacementItem> items) {
  std::vector<int> faults(items.size()), conflicts(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!placed[i] || items[i].rank == ItemRank::drawn) continue;
    faults[i] = placed.faults(i);
    conflicts[i] = faults[i] + placed.crossings(i);
  }
  // Those first that remain in conflict with what stays, then what was found, then those with most conflicts; rows,
  // which stand for many, last. Of several, the last one: overall dimensions are first.
  const auto rank = [&](std::size_t i) {
    return std::tuple(conflicts[i] > 0, !items[i].is_many, faults[i] > 0, items[i].rank == ItemRank::found,
                      conflicts[i]);
  };
  for (;;) {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
      if (rank(i) >= rank(worst)) worst = i;
    if (items.empty() || conflicts[worst] == 0) return;
    check(conflicts[worst] > 0 && placed[worst], "what has conflicts is placed");
    std::vector<std::size_t> gone = placed.guests(worst);
    gone.push_back(worst);
    std::erase_if(gone, [&](std::size_t i) { return !placed[i]; });
    for (const std::size_t number : gone) {
      for (std::size_t i = 0; i < items.size(); ++i)
        if (conflicts[i] > 0 && i != number && placed[i] && do_cross(*placed[i], *placed[number])) --conflicts[i];
      conflicts[number] = faults[number] = 0;
    }
    placed.take(worst);
  }
}

/// Places items one after the other, and lets them make way.
class Placer {
 public:
  Placer(std::span<const PlacementItem> items, Obstacles obstacles)
      : items_(items),
        order_(items.size()),
        placed_(items, std::move(obstacles)),
        best_(items),
        is_lost_(items.size(), false),
        stays_(items.size(), false) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return items[a].order < items[b].order; });
  }

  void place_all(const Progress& progress) {
    for (const std::size_t i : order_) {
      if (progress.is_out_of_time()) break;
      if (has_lost_twin(i))
        is_lost_[i] = true;
      else
        place(i);
      if (is_dropped(i)) note_lost(i);
      progress.advance(1);
    }
    const auto has_place = [this](std::size_t i) { return placed_[i].has_value() || may_leave(i); };
    check(progress.is_out_of_time() || std::all_of(order_.begin(), order_.end(), has_place),
          "what is drawn in any case has a place");
    place_crossed_anew(progress);
  }

  /// Takes out some of those that may be left out until none of these has conflicts, and puts back those for which
  /// there is room then. If some remain, less usual places are tried, and others make way.
  void leave_out(const Progress& progress) {
    check(!best_.is_crowded, "room is looked for once");
    const ItemArrangement::State all = placed_.state();
    take_out_crossed(placed_, items_);
    put_in(progress);
    const bool are_many = missing().size() > max_in_crowd;
    squeeze_in(progress);
    if (missing().empty() || are_many) return;
    best_.is_crowded = true;
    const ItemArrangement::State usual = placed_.state();
    const Missing without = count_missing();
    placed_.put_back(all);
    place_crossed_anew(progress);
    take_out_crossed(placed_, items_);
    put_in(progress);
    if (count_missing() >= without) placed_.put_back(usual);
    for (const std::size_t i : missing())
      if (!progress.is_out_of_time()) makes_room_in_crowd(i);
  }

  /// Where a leader still crosses another one, or worse, an earlier item moves if the sum of both costs falls.
  void improve(const Progress& progress) {
    const auto may_improve = [&](std::size_t i) { return placed_[i] && !items_[i].is_many && !placed_.has_guests(i); };
    std::vector<std::size_t> bad;
    for (const std::size_t i : order_)
      if (may_improve(i) && placed_.cost_around(i, cost_of_letter) >= cost_of_letter) bad.push_back(i);
    for (const std::size_t i : bad)
      if (!progress.is_out_of_time()) untangle(placed_, items_, i);
    std::erase_if(bad, [&](std::size_t i) { return placed_.cost_around(i, cost_of_letter) < cost_of_letter; });
    if (bad.size() > max_in_crowd) return;
    best_.is_crowded = true;
    for (const std::size_t i : bad)
      for (const std::size_t other : order_) {
        if (progress.is_out_of_time() || placed_.cost_around(i, cost_of_letter) < cost_of_letter) break;
        if (other != i && may_improve(other)) moves_for(i, other);
      }
  }

  [[nodiscard]] const PlacedDimensions& result() const { return placed_.all(); }

 private:
  // Those that later ones cross are placed anew, now that all others are known. No round makes anything worse. Those
  // whose places were all in a crowd would find no better one: there are more in it now.
  void place_crossed_anew(const Progress& progress) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
      for (const std::size_t i : order_) {
        if (!placed_[i] || is_lost_[i] || placed_.has_guests(i) || progress.is_out_of_time()) continue;
        if (placed_.cost_around(i, cost_of_text) < cost_of_text) continue;
        placed_.take(i);
        place(i);
      }
  }
  // Places both anew, the second one where the first one leaves room; keeps that if their cost falls.
  bool moves_for(std::size_t i, std::size_t other) {
    const ItemArrangement::Place before = placed_.place_of(i), other_before = placed_.place_of(other);
    const auto cost_of = [&](std::size_t one) { return placed_.own_cost(one) + placed_.cost_around(one); };
    const double cost = cost_of(i) + cost_of(other);
    const int count = placed_.conflicts(i) + placed_.conflicts(other);
    placed_.take(other);
    placed_.take(i);
    place(i);
    if (placed_[i]) place(other);
    if (placed_[i] && placed_[other] && placed_.conflicts(i) + placed_.conflicts(other) <= count &&
        cost_of(i) + cost_of(other) < cost - cost_of_crossing)
      return true;
    for (const std::size_t one : {i, other})
      if (placed_[one]) placed_.take(one);
    placed_.put_back(i, before);
    placed_.put_back(other, other_before);
    return false;
  }
  // What is required first.
  void put_in(const Progress& progress) {
    const std::vector<std::size_t> all = missing();
    const bool are_few = all.size() <= max_in_crowd;
    best_.keeps_all = are_few;
    lost_.clear();
    for (const std::size_t i : all) {
      if (progress.is_out_of_time()) return;
      if (has_lost_twin(i) || finds_room(i) || (are_few && makes_room(i))) continue;
      note_lost(i);
    }
  }
  // Where leaders cross, for a while, until places are exchanged. After so many in turn for which there is no room,
  // there is hardly any for others.
  void squeeze_in(const Progress& progress) {
    std::size_t failed = 0;
    best_.is_crowded = true;
    for (const std::size_t i : order_) {
      if (placed_[i] || !items_[i].instead || failed > max_in_crowd || progress.is_out_of_time()) continue;
      const ItemArrangement::State before = placed_.state();
      place(i);
      const bool has_place = placed_[i] && untangle(placed_, items_, i);
      if (!has_place) placed_.put_back(before);
      failed = has_place ? 0 : failed + 1;
    }
    best_.is_crowded = false;
  }
  void place(std::size_t i) {
    const BestPlacement best = best_.find(i, placed_);
    is_lost_[i] = best.dimension == nullptr || best.is_crowd;
    if (best.dimension == nullptr) return;
    placed_.put(i, *best.dimension, best.own);
    if (items_[i].is_clear && !is_lost_[i]) is_lost_[i] = placed_.conflicts(i) > 0;
    if (is_dropped(i)) placed_.take(i);
  }

  [[nodiscard]] bool may_leave(std::size_t i) const { return items_[i].rank != ItemRank::drawn; }
  [[nodiscard]] bool is_found(std::size_t i) const { return items_[i].rank == ItemRank::found; }
  [[nodiscard]] bool is_required(std::size_t i) const { return items_[i].rank == ItemRank::required; }
  [[nodiscard]] bool may_move(std::size_t i) const { return may_leave(i) && !stays_[i] && !placed_.has_guests(i); }
  // What is required takes no place that makes others hard to read. There is less room later on.
  [[nodiscard]] bool is_dropped(std::size_t i) const { return is_lost_[i] && is_required(i) && !best_.is_crowded; }
  // While items only come, there is no place for one that is no smaller than one like it for which there was none.
  [[nodiscard]] bool has_lost_twin(std::size_t i) const {
    const auto twin = is_required(i) && !items_[i].like.empty() ? lost_.find(items_[i].like) : lost_.end();
    return twin != lost_.end() && items_[i].size.x >= twin->second.x && items_[i].size.y >= twin->second.y;
  }
  void note_lost(std::size_t i) {
    if (is_required(i) && !items_[i].like.empty()) lost_.try_emplace(items_[i].like, items_[i].size);
  }

  bool finds_room(std::size_t i) {
    place(i);
    if (!placed_[i]) return false;
    if (placed_.conflicts(i) == 0) return true;
    placed_.take(i);
    return false;
  }
  // Moves all that is where the item is placed, and in a crowd what is where these would be, `deep` times; otherwise
  // everything is as before.
  bool clears(std::size_t number, int deep, const ItemArrangement::State& before) {
    std::vector<std::size_t> moved;
    bool all_move = placed_[number] && placed_.faults(number) == 0;
    for (std::size_t i = 0; i < items_.size() && all_move; ++i) {
      if (i == number || !placed_[i] || !do_cross(*placed_[number], *placed_[i])) continue;
      all_move = may_move(i);
      moved.push_back(i);
    }
    stays_[number] = true;
    if (all_move) {
      for (const std::size_t i : moved) placed_.take(i);
      all_move = std::all_of(moved.begin(), moved.end(), [&](std::size_t i) {
        return finds_room(i) || (deep > 0 && moves_others(i, deep - 1)) || gives_way(i, number);
      });
    }
    stays_[number] = false;
    if (!all_move) placed_.put_back(before);
    check(all_move == placed_[number].has_value(), "an item that finds no room is not placed");
    return all_move;
  }
  bool moves_others(std::size_t number, int deep = 0) {
    const ItemArrangement::State before = placed_.state();
    place(number);
    return clears(number, deep, before);
  }
  // The same at its other places, the cheapest ones first.
  bool displaces(std::size_t number, int deep) {
    check(is_required(number), "what was found displaces nothing");
    if (items_[number].host) return false;
    std::vector<ItemPlacement> all = items_[number].usual(nullptr);
    std::vector<BestPlacement> best;
    for (ItemPlacement& one : all) {
      const auto& drawn = one.drawn();
      const auto is_held = [&](std::size_t i) { return placed_[i] && !may_move(i) && do_cross(*drawn, *placed_[i]); };
      if (placed_.obstacles().faults(*drawn) == 0 && std::none_of(order_.begin(), order_.end(), is_held))
        best.push_back({drawn, one.cost + placed_.obstacles().cost(*drawn, HUGE_VAL), one.cost});
    }
    std::ranges::stable_sort(best, {}, &BestPlacement::cost);
    best.resize(std::min(best.size(), max_in_crowd));
    return std::any_of(best.begin(), best.end(), [&](const BestPlacement& one) {
      const ItemArrangement::State before = placed_.state();
      placed_.put(number, *one.dimension, one.own);
      return clears(number, deep, before);
    });
  }
  [[nodiscard]] bool gives_way(std::size_t i, std::size_t number) const {
    return is_required(number) && is_found(i) && !items_[i].is_many;
  }
  // Moves another one of those that may be left out.
  bool makes_room(std::size_t i) {
    if (items_[i].is_many) return moves_others(i);
    for (std::size_t other = 0; other < items_.size(); ++other) {
      if (!placed_[other] || items_[other].is_many || !may_move(other)) continue;
      const ItemArrangement::Place before = placed_.place_of(other);
      placed_.take(other);
      if (finds_room(i)) {
        if (finds_room(other)) return true;
        placed_.take(i);
      }
      placed_.put_back(other, before);
    }
    return false;
  }
  void makes_room_in_crowd(std::size_t i) {
    constexpr int deep = 3;
    if (placed_[i] || finds_room(i) || moves_others(i, deep) || items_[i].is_many) return;
    if (!makes_room(i) && is_required(i)) displaces(i, deep);
  }

  // Of what may be left out: what is required first.
  [[nodiscard]] std::vector<std::size_t> missing() const {
    std::vector<std::size_t> numbers;
    for (const ItemRank rank : {ItemRank::required, ItemRank::found})
      for (std::size_t i = 0; i < items_.size(); ++i)
        if (!placed_[i] && items_[i].rank == rank) numbers.push_back(i);
    return numbers;
  }
  [[nodiscard]] Missing count_missing() const {
    const std::vector<std::size_t> all = missing();
    const auto required = std::count_if(all.begin(), all.end(), [this](std::size_t i) { return is_required(i); });
    return {static_cast<std::size_t>(required), all.size()};
  }

  std::span<const PlacementItem> items_;
  std::vector<std::size_t> order_;
  ItemArrangement placed_;
  BestPlaces best_;
  std::vector<bool> is_lost_;                   ///< whether every place was in a crowd
  std::map<std::vector<double>, Vec2> lost_{};  ///< size of the first item like this that was
  std::vector<bool> stays_;                     ///< while others are moved
};

}  // namespace

PlacedDimensions place_items(std::span<const PlacementItem> items, const Obstacles& obstacles,
                             const Progress& progress) {
  Placer placer(items, obstacles);
  placer.place_all(progress);
  if (!progress.is_out_of_time()) placer.leave_out(progress);
  placer.improve(progress);
  PlacedDimensions placed = placer.result();
  check(placed.size() == items.size(), "every item has a place or none");
  return placed;
}

}  // namespace epura::sheet
