// SPDX-License-Identifier: Apache-2.0
// Places all that stands at a view, whatever it is: one search among candidates, their costs, and what they may
// displace. Field: point-feature label placement (Christensen, Marks, Shieber 1995).
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "dimensions/obstacles.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

/// A possible placement, and its own cost without regard to other objects. Hundreds of leaders are possible at a
/// circle, of which the first ones do, as a rule: each is drawn when it is looked at.
class ItemPlacement {
 public:
  ItemPlacement(PlacedDimension drawn, double own)
      : cost(own), drawn_(std::make_shared<const PlacedDimension>(std::move(drawn))) {}
  ItemPlacement(std::function<PlacedDimension()> draw, double own, std::optional<std::size_t> on = {})
      : cost(own), way(on), draw_(std::move(draw)) {}

  const std::shared_ptr<const PlacedDimension>& drawn() {
    if (!drawn_) drawn_ = std::make_shared<const PlacedDimension>(draw_());
    return drawn_;
  }

  double cost;
  /// Of those with the same number, the first leader of each is a part of that of the next one.
  std::optional<std::size_t> way{};

 private:
  std::shared_ptr<const PlacedDimension> drawn_{};
  std::function<PlacedDimension()> draw_{};
};

/// Why something stands on the sheet: it was found in faces of the part, and gives way; it is required, and is left out
/// where there is no room; or it is drawn whatever it crosses.
enum class ItemRank { found, required, drawn };

/// Something that stands at a view.
struct PlacementItem {
  using Places = std::function<std::vector<ItemPlacement>(const PlacedDimension* host)>;

  Places usual;
  Places in_crowd{};                ///< more of them, which are less usual
  std::vector<Places> elsewhere{};  ///< at equal features, where that is clearly better
  /// In the place of another one that has this, too; nothing where its leader would cross itself.
  std::function<std::optional<ItemPlacement>(const PlacedDimension& other)> instead{};
  std::array<double, 3> order{};  ///< in ascending order, items are placed one after the other
  ItemRank rank = ItemRank::drawn;
  bool is_many = false;               ///< a row of lengths, which is left out last and makes way for nothing
  bool is_clear = false;              ///< it has no place where it crosses anything, not even for a while
  std::optional<std::size_t> host{};  ///< number of an earlier item, at which it stands
  std::vector<double> like{};         ///< equal for items with the same places, beside their sizes; empty: unknown
  Vec2 size{0, 0};                    ///< of the first text
};

/// The items where they cost least, each after those before it; crossed ones are placed anew, and what has no room may
/// move others, or take the places of those that were found. Where leaders cross, an earlier item moves if the sum of
/// their costs falls. What was found or is required is left out where it would cross something, and what there is no
/// time for. The same for any number of threads.
PlacedDimensions place_items(std::span<const PlacementItem> items, const Obstacles& obstacles,
                             const Progress& progress = {});

}  // namespace epura::sheet
