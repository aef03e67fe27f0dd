// SPDX-License-Identifier: Apache-2.0
// What is on the paper around a view, and how much worse that makes a place.
#pragma once

#include <optional>
#include <vector>

#include "dimensions/conflicts.hpp"
#include "dimensions/hatched_areas.hpp"
#include "drawing/drawing.hpp"
#include "drawing/ink_cells.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/box_index.hpp"
#include "sheet/boxes.hpp"
#include "sheet/marks.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

inline constexpr double on_line = 0.1;        ///< mm, by which what is on a line may be beside it
inline constexpr double nearest_lines = 0.7;  ///< mm between parallel lines. ISO 128-2

class InkIndex {
 public:
  explicit InkIndex(const drawing::ViewDrawing& drawing);

  /// How many lines of the drawing pass through the box, as ink_in counts them.
  [[nodiscard]] int in(const TurnedBox& box) const;

 private:
  const drawing::ViewDrawing& drawing_;
  drawing::InkCells cells_;  ///< numbers of segments
};

/// A closed round line of a view, mm on paper.
struct Disc {
  Vec2 centre;
  double radius;
};

/// The visible ones, such as the rims of holes.
std::vector<Disc> discs_of(const drawing::ViewDrawing& drawing);

/// Whether a leader to something outside a disc goes through it, or seems to end at it: its arrow is inside, not on the
/// rim, and no smaller.
bool goes_through(const LeaderLine& leader, const Disc& disc);

/// What is on the paper, indexed once for everything that is placed at a view.
class Obstacles {
 public:
  /// Refers to the drawing.
  Obstacles(const drawing::ViewDrawing& drawing, const Neighbours& neighbours);

  void add(const PlacedDimension& item);
  void remove(const PlacedDimension& item);

  /// The cost of a place; computed no further once it exceeds `max`.
  [[nodiscard]] double cost(const PlacedDimension& item, double max) const;
  /// What a leader costs at least, and every longer one from its tip through its elbow.
  [[nodiscard]] double cost_of_way(const LeaderLine& leader) const;

  /// How many of four faults it has, whatever else is placed: something is beyond the limits of the sheet; a text is on
  /// something else on the sheet, or a line goes through a text there; a line or text is inside another view, where it
  /// would be read as a size of that; lines of the view go through a text.
  [[nodiscard]] int faults(const PlacedDimension& item) const;
  [[nodiscard]] bool meets(const PlacedDimension& item) const;
  [[nodiscard]] bool is_in_other_view(const PlacedDimension& item) const;
  [[nodiscard]] bool is_on_lines(const PlacedDimension& item) const;

 private:
  [[nodiscard]] bool is_beyond(const PlacedDimension& item) const;
  [[nodiscard]] double cost_of_line(const TurnedBox& line, double max) const;
  [[nodiscard]] double cost_of_leader(const LeaderLine& leader) const;

  std::optional<Rectangle> paper_;
  BoxIndex others_, views_, letters_, other_texts_, other_zones_;
  InkIndex ink_;
  std::vector<Disc> discs_;
  HatchedAreas hatched_;
  BoxIndex zones_{}, texts_{}, lines_{}, leaders_{}, arrows_{};  ///< of what is placed
};

/// Whether an item is in conflict with another one, or with the obstacles, which are all but these; the limits of the
/// sheet aside.
bool have_conflicts(const PlacedDimensions& placed, const Obstacles& obstacles);

}  // namespace epura::sheet
