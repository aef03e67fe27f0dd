// SPDX-License-Identifier: Apache-2.0
// Places for labels of points and lines: never on other lettering, marks or arrows, never outside their room, clear of
// lines if possible, and with no line between a label and what it names, since it would seem to name that line.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "sheet/box_index.hpp"
#include "sheet/boxes.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// A point that a label may name.
struct LabelAnchor {
  Vec2 at;
  Vec2 outwards{0, 0};  ///< direction in which the label stands if there is room; length 1. Zero: any
};

struct Label {
  Vec2 size;                         ///< of its box, mm
  std::vector<LabelAnchor> anchors;  ///< the best first; any of them will do
  double from = 0;                   ///< mm around the anchor that stay free, for its mark
  bool inside = false;               ///< it may stand on its anchor: it names an area
};

struct LabelPlace {
  Rectangle box;
  Vec2 anchor;
  std::array<Vec2, 2> tie;  ///< the gap between the two, in which nothing else stands; of no length: there is none
  bool has_leader = false;  ///< along the tie: it is so long that another point might be meant
  bool is_on_line = false;  ///< the anchor is
};

/// What is in the room before the labels, and then the labels.
class LabelRoom {
 public:
  explicit LabelRoom(const Rectangle& area);

  /// Labels and leaders are clear of lines if possible.
  void add_line(const Vec2& from, const Vec2& to);
  /// Labels are clear of marks; leaders if possible.
  void add_mark(const TurnedBox& box);
  /// Labels and leaders are clear of lettering.
  void add_lettering(const TurnedBox& box);

  /// Places labels one after another, then moves those that have a better place among the others, until none has.
  /// Those that find none come first in another attempt; a label without a place after some of these gets none.
  std::vector<std::optional<LabelPlace>> place(std::span<const Label> labels);

 private:
  struct Candidate;
  using Places = std::vector<std::optional<LabelPlace>>;

  [[nodiscard]] std::vector<Candidate> candidates_for(const Label& label) const;
  [[nodiscard]] double cost_of(const Label& label, const Candidate& candidate, double bound) const;
  [[nodiscard]] std::optional<LabelPlace> best_place(const Label& label) const;
  Places placed_in_order(std::span<const Label> labels, std::span<const std::size_t> order);
  void take(const LabelPlace& place);
  void give_back(const LabelPlace& place);

  Rectangle area_;
  BoxIndex lines_{};      ///< lines, marks and ties
  BoxIndex solids_{};     ///< what no label touches
  BoxIndex lettering_{};  ///< what no leader touches
};

}  // namespace epura::sheet
