// SPDX-License-Identifier: Apache-2.0
// Items where they stand for now, each of which is an obstacle to the others.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dimensions/obstacles.hpp"
#include "dimensions/place_items.hpp"

namespace epura::sheet {

class ItemArrangement {
 public:
  ItemArrangement(std::span<const PlacementItem> items, Obstacles obstacles);

  [[nodiscard]] const PlacedDimensions& all() const { return placed_; }
  [[nodiscard]] const std::optional<PlacedDimension>& operator[](std::size_t item) const { return placed_[item]; }
  [[nodiscard]] const Obstacles& obstacles() const { return obstacles_; }

  /// The item has no place yet; `own` is the cost of this one, whatever else is placed.
  void put(std::size_t item, PlacedDimension place, double own);
  /// Takes out a placed item, and what stands at it.
  void take(std::size_t item);

  /// Places and their own costs.
  using State = std::pair<PlacedDimensions, std::vector<double>>;
  [[nodiscard]] State state() const { return {placed_, own_}; }
  void put_back(const State& before);
  using Place = std::pair<std::optional<PlacedDimension>, double>;
  [[nodiscard]] Place place_of(std::size_t item) const { return {placed_[item], own_[item]}; }
  void put_back(std::size_t item, const Place& before);

  /// The others that stand at an item, placed or not.
  [[nodiscard]] const std::vector<std::size_t>& guests(std::size_t item) const { return guests_[item]; }
  [[nodiscard]] bool has_guests(std::size_t item) const;

  /// Of a placed item: its own cost; the cost of what is around it, computed no further once it exceeds `max`; its
  /// faults, and with how many others it shares its place.
  [[nodiscard]] double own_cost(std::size_t item) const { return own_[item]; }
  [[nodiscard]] double cost_around(std::size_t item, double max = HUGE_VAL);
  [[nodiscard]] int faults(std::size_t item) const { return obstacles_.faults(*placed_[item]); }
  [[nodiscard]] int crossings(std::size_t item) const;
  [[nodiscard]] int conflicts(std::size_t item) const { return faults(item) + crossings(item); }

 private:
  std::vector<std::vector<std::size_t>> guests_;
  Obstacles obstacles_;
  PlacedDimensions placed_;
  std::vector<double> own_;
};

}  // namespace epura::sheet
