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
#include "dimensions/costs.hpp"
#include "dimensions/obstacles.hpp"

namespace epura::sheet {

namespace {

struct BestPlacement {
  const PlacedDimension* dimension;
  double cost;
  double own = 0;  ///< as in ItemPlacement
};

// The cheapest placement if it costs less than `best`. They are in ascending order of their cost.
BestPlacement better_of(std::vector<ItemPlacement>& placements, const Obstacles& obstacles, BestPlacement best) {
  for (ItemPlacement& placement : placements) {
    if (placement.cost >= best.cost) break;
    const PlacedDimension& drawn = placement.drawn();
    const double cost = placement.cost + obstacles.cost(drawn, best.cost - placement.cost);
    if (cost < best.cost) best = {&drawn, cost, placement.cost};
  }
  return best;
}

std::vector<ItemPlacement> in_order(std::vector<ItemPlacement> placements) {
  std::stable_sort(placements.begin(), placements.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return placements;
}

/// How many items have no place: of two arrangements, the one with fewer of what is required is better.
struct Missing {
  std::size_t required = 0, all = 0;
  auto operator<=>(const Missing&) const = default;
};

/// Places items one after the other, and lets them make way.
class Placer {
 public:
  Placer(std::span<const PlacementItem> items, Obstacles obstacles)
      : items_(items),
        order_(items.size()),
        guests_(items.size()),
        obstacles_(std::move(obstacles)),
        placed_(items.size()),
        own_(items.size()),
        is_lost_(items.size(), false),
        stays_(items.size(), false) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return items[a].order < items[b].order; });
    for (std::size_t i = 0; i < items.size(); ++i)
      if (items[i].host) guests_[*items[i].host].push_back(i);
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
    check(!is_crowded_, "room is looked for once");
    const State all = state();
    take_out_crossed();
    put_in(progress);
    if (missing().empty() || missing().size() > max_in_crowd) return;
    is_crowded_ = true;
    const State usual = state();
    const Missing without = count_missing();
    put_back(all);
    place_crossed_anew(progress);
    take_out_crossed();
    put_in(progress);
    if (count_missing() >= without) put_back(usual);
    for (const std::size_t i : missing())
      if (!progress.is_out_of_time()) makes_room_in_crowd(i);
  }

  /// Where a leader still crosses another one, or worse, an earlier item moves if the sum of both costs falls.
  void improve(const Progress& progress) {
    const auto may_improve = [&](std::size_t i) { return placed_[i] && !items_[i].is_many && !has_guests(i); };
    std::vector<std::size_t> bad;
    for (const std::size_t i : order_)
      if (may_improve(i) && cost_around(i, cost_of_letter) >= cost_of_letter) bad.push_back(i);
    if (bad.size() > max_in_crowd) return;
    is_crowded_ = true;
    for (const std::size_t i : bad)
      for (const std::size_t other : order_) {
        if (progress.is_out_of_time() || cost_around(i, cost_of_letter) < cost_of_letter) break;
        if (other != i && may_improve(other)) moves_for(i, other);
      }
  }

  PlacedDimensions result() { return std::move(placed_); }

 private:
  using State = std::pair<PlacedDimensions, std::vector<double>>;
  [[nodiscard]] State state() const { return {placed_, own_}; }

  // Those that later ones cross are placed anew, now that all others are known. No round makes anything worse. Those
  // whose places were all in a crowd would find no better one: there are more in it now.
  void place_crossed_anew(const Progress& progress) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round)
      for (const std::size_t i : order_) {
        if (!placed_[i] || is_lost_[i] || has_guests(i) || progress.is_out_of_time()) continue;
        if (cost_around(i, cost_of_text) < cost_of_text) continue;
        take(i);
        place(i);
      }
  }
  double cost_around(std::size_t i, double max = HUGE_VAL) {
    obstacles_.remove(*placed_[i]);
    const double cost = obstacles_.cost(*placed_[i], max);
    obstacles_.add(*placed_[i]);
    return cost;
  }
  // Places both anew, the second one where the first one leaves room; keeps that if their cost falls.
  bool moves_for(std::size_t i, std::size_t other) {
    const auto before = std::pair(placed_[i], own_[i]), other_before = std::pair(placed_[other], own_[other]);
    const auto sum = [&] { return own_[i] + own_[other] + cost_around(i) + cost_around(other); };
    const auto conflicts = [&] { return conflicts_of(i) + conflicts_of(other); };
    const double cost = sum();
    const int count = conflicts();
    take(other);
    take(i);
    place(i);
    if (placed_[i]) place(other);
    if (placed_[i] && placed_[other] && conflicts() <= count && sum() < cost - cost_of_crossing) return true;
    put_back(i, before);
    put_back(other, other_before);
    return false;
  }
  void take_out_crossed() {
    std::vector<int> faults(items_.size()), conflicts(items_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (!placed_[i] || !may_leave(i)) continue;
      faults[i] = obstacles_.faults(*placed_[i]);
      conflicts[i] = faults[i] + crossings_of_item(i);
    }
    // Those first that remain in conflict with what stays, then what was found, then those with most conflicts; rows,
    // which stand for many, last. Of several, the last one: overall dimensions are first.
    const auto rank = [&](std::size_t i) {
      return std::tuple(conflicts[i] > 0, !items_[i].is_many, faults[i] > 0, is_found(i), conflicts[i]);
    };
    for (;;) {
      std::size_t worst = 0;
      for (std::size_t i = 0; i < items_.size(); ++i)
        if (rank(i) >= rank(worst)) worst = i;
      if (items_.empty() || conflicts[worst] == 0) return;
      check(conflicts[worst] > 0 && placed_[worst], "what has conflicts is placed");
      std::vector<std::size_t> gone = guests_[worst];
      gone.push_back(worst);
      std::erase_if(gone, [this](std::size_t i) { return !placed_[i]; });
      for (const std::size_t number : gone) {
        for (std::size_t i = 0; i < items_.size(); ++i)
          if (conflicts[i] > 0 && i != number && placed_[i] && do_cross(*placed_[i], *placed_[number])) --conflicts[i];
        conflicts[number] = faults[number] = 0;
      }
      take(worst);
    }
  }
  // What is required first.
  void put_in(const Progress& progress) {
    const std::vector<std::size_t> all = missing();
    const bool are_few = all.size() <= max_in_crowd;
    is_searching_ = are_few;
    lost_.clear();
    for (const std::size_t i : all) {
      if (progress.is_out_of_time()) return;
      if (has_lost_twin(i) || finds_room(i) || (are_few && makes_room(i))) continue;
      note_lost(i);
    }
  }
  void place(std::size_t i) {
    const PlacementItem& item = items_[i];
    const PlacedDimension* host = item.host && placed_[*item.host] ? &*placed_[*item.host] : nullptr;
    if (item.host && !host) return;
    // Rows are large, and in a search for room all are tried again and again.
    const auto [known, is_new] = usual_.try_emplace(i);
    if (is_new) known->second = in_order(item.usual(host));
    const double max = item.is_clear && !is_crowded_ ? cost_of_text : cost_in_crowd;
    BestPlacement best = better_of(known->second, obstacles_, {nullptr, max});
    is_lost_[i] = best.dimension == nullptr;
    if (is_crowded_ && best.cost >= cost_of_letter) best = better_of(more_placements(i), obstacles_, best);
    if (best.dimension == nullptr && !known->second.empty())
      best = {&known->second.front().drawn(), best.cost, known->second.front().cost};
    if (best.dimension != nullptr) placed_[i] = *best.dimension;
    own_[i] = best.own;
    if (host || (!is_searching_ && !item.is_many)) usual_.erase(known);
    if (placed_[i] && item.is_clear && !is_lost_[i]) is_lost_[i] = conflicts_of(i) > 0;
    if (is_dropped(i)) placed_[i].reset();
    if (!placed_[i]) return;
    place_elsewhere(i, best.cost);
    obstacles_.add(*placed_[i]);
    check(own_[i] >= 0, "a place has a cost");
  }
  // If that is clearly better.
  void place_elsewhere(std::size_t i, double cost) {
    for (const PlacementItem::Places& places : items_[i].elsewhere) {
      const double bar = cost - cost_of_crossing;
      if (bar <= cost_of_slope) return;  // hardly anything is better
      std::vector<ItemPlacement> there = in_order(places(nullptr));
      const BestPlacement better = better_of(there, obstacles_, {nullptr, bar});
      if (better.dimension == nullptr) continue;
      placed_[i] = *better.dimension;
      own_[i] = better.own;
      cost = better.cost;
    }
  }
  std::vector<ItemPlacement>& more_placements(std::size_t i) {
    auto [known, is_new] = more_.try_emplace(i);
    if (is_new && items_[i].in_crowd) known->second = in_order(items_[i].in_crowd(nullptr));
    return known->second;
  }

  [[nodiscard]] bool may_leave(std::size_t i) const { return items_[i].rank != ItemRank::drawn; }
  [[nodiscard]] bool is_found(std::size_t i) const { return items_[i].rank == ItemRank::found; }
  [[nodiscard]] bool is_required(std::size_t i) const { return items_[i].rank == ItemRank::required; }
  [[nodiscard]] bool has_guests(std::size_t i) const {
    return std::any_of(guests_[i].begin(), guests_[i].end(), [this](std::size_t k) { return placed_[k].has_value(); });
  }
  [[nodiscard]] bool may_move(std::size_t i) const { return may_leave(i) && !stays_[i] && !has_guests(i); }
  // What is required takes no place that makes others hard to read. There is less room later on.
  [[nodiscard]] bool is_dropped(std::size_t i) const { return is_lost_[i] && is_required(i) && !is_crowded_; }
  // While items only come, there is no place for one that is no smaller than one like it for which there was none.
  [[nodiscard]] bool has_lost_twin(std::size_t i) const {
    const auto twin = is_required(i) && !items_[i].like.empty() ? lost_.find(items_[i].like) : lost_.end();
    return twin != lost_.end() && items_[i].size.x >= twin->second.x && items_[i].size.y >= twin->second.y;
  }
  void note_lost(std::size_t i) {
    if (is_required(i) && !items_[i].like.empty()) lost_.try_emplace(items_[i].like, items_[i].size);
  }

  // With what stands at it.
  void take(std::size_t i) {
    obstacles_.remove(*placed_[i]);
    placed_[i].reset();
    for (const std::size_t guest : guests_[i])
      if (placed_[guest]) take(guest);
  }
  bool finds_room(std::size_t i) {
    place(i);
    if (!placed_[i]) return false;
    if (conflicts_of(i) == 0) return true;
    take(i);
    return false;
  }
  // Moves all that is where the item is placed, and in a crowd what is where these would be, `deep` times; otherwise
  // everything is as before.
  bool clears(std::size_t number, int deep, const State& before) {
    std::vector<std::size_t> moved;
    bool all_move = placed_[number] && obstacles_.faults(*placed_[number]) == 0;
    for (std::size_t i = 0; i < placed_.size() && all_move; ++i) {
      if (i == number || !placed_[i] || !do_cross(*placed_[number], *placed_[i])) continue;
      all_move = may_move(i);
      moved.push_back(i);
    }
    stays_[number] = true;
    if (all_move) {
      for (const std::size_t i : moved) take(i);
      all_move = std::all_of(moved.begin(), moved.end(), [&](std::size_t i) {
        return finds_room(i) || (deep > 0 && moves_others(i, deep - 1)) || gives_way(i, number);
      });
    }
    stays_[number] = false;
    if (!all_move) put_back(before);
    check(all_move == placed_[number].has_value(), "an item that finds no room is not placed");
    return all_move;
  }
  bool moves_others(std::size_t number, int deep = 0) {
    const State before = state();
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
      const PlacedDimension& drawn = one.drawn();
      const auto is_held = [&](std::size_t i) { return placed_[i] && !may_move(i) && do_cross(drawn, *placed_[i]); };
      if (obstacles_.faults(drawn) == 0 && std::none_of(order_.begin(), order_.end(), is_held))
        best.push_back({&drawn, one.cost + obstacles_.cost(drawn, HUGE_VAL), one.cost});
    }
    std::ranges::stable_sort(best, {}, &BestPlacement::cost);
    best.resize(std::min(best.size(), max_in_crowd));
    return std::any_of(best.begin(), best.end(), [&](const BestPlacement& one) {
      const State before = state();
      placed_[number] = *one.dimension;
      own_[number] = one.own;
      obstacles_.add(*one.dimension);
      return clears(number, deep, before);
    });
  }
  [[nodiscard]] bool gives_way(std::size_t i, std::size_t number) const {
    return is_required(number) && is_found(i) && !items_[i].is_many;
  }
  void put_back(const State& before) {
    for (const std::optional<PlacedDimension>& one : placed_)
      if (one) obstacles_.remove(*one);
    std::tie(placed_, own_) = before;
    for (const std::optional<PlacedDimension>& one : placed_)
      if (one) obstacles_.add(*one);
  }
  void put_back(std::size_t i, const std::pair<std::optional<PlacedDimension>, double>& before) {
    if (placed_[i]) take(i);
    std::tie(placed_[i], own_[i]) = before;
    obstacles_.add(*placed_[i]);
  }
  // Moves another one of those that may be left out.
  bool makes_room(std::size_t i) {
    if (items_[i].is_many) return moves_others(i);
    for (std::size_t other = 0; other < items_.size(); ++other) {
      if (!placed_[other] || items_[other].is_many || !may_move(other)) continue;
      const auto before = std::pair(placed_[other], own_[other]);
      take(other);
      if (finds_room(i)) {
        if (finds_room(other)) return true;
        take(i);
      }
      put_back(other, before);
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
  [[nodiscard]] int crossings_of_item(std::size_t number) const {
    int count = 0;
    for (std::size_t i = 0; i < placed_.size(); ++i)
      if (i != number && placed_[i] && do_cross(*placed_[number], *placed_[i])) ++count;
    return count;
  }
  [[nodiscard]] int conflicts_of(std::size_t number) const {
    return obstacles_.faults(*placed_[number]) + crossings_of_item(number);
  }

  std::span<const PlacementItem> items_;
  std::vector<std::size_t> order_;
  std::vector<std::vector<std::size_t>> guests_;  ///< by item: those that stand at it
  Obstacles obstacles_;
  PlacedDimensions placed_;
  std::vector<double> own_;                     ///< their own costs
  std::vector<bool> is_lost_;                   ///< whether every place was in a crowd
  std::map<std::vector<double>, Vec2> lost_{};  ///< size of the first item like this that was
  std::vector<bool> stays_;                     ///< while others are moved
  std::map<std::size_t, std::vector<ItemPlacement>> usual_{}, more_{};
  bool is_searching_ = false;  ///< whether room is looked for
  bool is_crowded_ = false;    ///< whether less usual placements are tried, too
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
