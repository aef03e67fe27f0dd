// SPDX-License-Identifier: Apache-2.0
// Where one item stands best among the others.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "dimensions/item_arrangement.hpp"
#include "dimensions/place_items.hpp"

namespace epura::sheet {

/// A place that was found, or none.
struct BestPlacement {
  std::shared_ptr<const PlacedDimension> dimension{};
  double cost;
  double own = 0;         ///< as in ItemPlacement
  bool is_crowd = false;  ///< whether every place was in a crowd, and this is the first one
};

/// Looks for places, and keeps those that it will look at again.
class BestPlaces {
 public:
  explicit BestPlaces(std::span<const PlacementItem> items) : items_(items) {}

  bool keeps_all = false;   ///< the same items are placed again and again
  bool is_crowded = false;  ///< less usual places are tried for all, even where texts cross lines

  /// Of an item that has no place in the arrangement. None if it stands at something that has no place either.
  BestPlacement find(std::size_t item, const ItemArrangement& placed);

 private:
  [[nodiscard]] BestPlacement elsewhere(const PlacementItem& item, BestPlacement best,
                                        const Obstacles& obstacles) const;

  std::span<const PlacementItem> items_;
  std::map<std::size_t, std::vector<ItemPlacement>> usual_{}, more_{};
};

}  // namespace epura::sheet
