// SPDX-License-Identifier: Apache-2.0
// What is on the paper around a dimension, and how much worse each fault makes a place.
#pragma once

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/ink_cells.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/dimensions/box_index.hpp"
#include "sheet/dimensions/boxes.hpp"
#include "sheet/dimensions/conflicts.hpp"
#include "sheet/dimensions/marks.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

class InkIndex {
 public:
  explicit InkIndex(const drawing::ViewDrawing& drawing);

  /// How many lines of the drawing pass through the box, as ink_in counts them.
  [[nodiscard]] int in(const TurnedBox& box) const;

 private:
  const drawing::ViewDrawing& drawing_;
  drawing::InkCells cells_;  ///< numbers of segments
};

// Faults that make a drawing hard to read outweigh all those that only make it less tidy.
inline constexpr double cost_of_zone = 1000;   ///< two dimensions at the same position, or one inside another view
inline constexpr double cost_of_text = 300;    ///< a line through a text
inline constexpr double cost_of_letter = 100;  ///< a line that is interrupted at a letter, a leader through another
inline constexpr double cost_of_other = 20;    ///< a line through something else on the sheet, a leader through a hole
inline constexpr double cost_of_crossing = 3;
inline constexpr double cost_of_ink = 0.3;  ///< a line of the drawing that a leader crosses

/// A closed round line of a view, mm on paper.
struct Disc {
  Vec2 centre;
  double radius;
};

/// The visible ones, such as the rims of holes.
std::vector<Disc> discs_of(const drawing::ViewDrawing& drawing);

/// Whether a leader to something outside a disc goes through it.
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
