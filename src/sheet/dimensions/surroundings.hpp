// SPDX-License-Identifier: Apache-2.0
// What is on the paper around a dimension, and how much worse that makes its place.
#pragma once

#include <optional>
#include <vector>

#include "dimensions/conflicts.hpp"
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

/// Objects already on the paper.
class Surroundings {
 public:
  /// Refers to the drawing.
  Surroundings(const drawing::ViewDrawing& drawing, const Neighbours& neighbours);

  void add(const PlacedDimension& dimension);
  void remove(const PlacedDimension& dimension);

  /// The cost of a placed dimension; computed no further once it exceeds `max`.
  [[nodiscard]] double cost(const PlacedDimension& dimension, double max) const;

 private:
  [[nodiscard]] double cost_of_leader(const LeaderLine& leader) const;

  std::optional<Rectangle> paper_;
  BoxIndex others_, views_, letters_;
  InkIndex ink_;
  std::vector<Disc> discs_;
  BoxIndex zones_, texts_{}, lines_{}, leaders_{};
};

}  // namespace epura::sheet
