// SPDX-License-Identifier: Apache-2.0
// Whether a view shows the circle that a dimension measures.
#pragma once

#include <array>
#include <vector>

#include "dimensions/measure.hpp"
#include "dimensions/obstacles.hpp"
#include "drawing/drawing.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// The lines of a drawing along a circle, or along the part of it that is an arc, and on the face of the part whose
/// circle it is: lines of others may look the same on paper. Null for the world: parts of it are elsewhere in the view.
std::vector<LineOfCircle> lines_along(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle,
                                      const world::World* world);

/// Whether the drawing has a line along a circle, or holes on it, or, if the circle is seen edge-on, a line that begins
/// or passes at an end of its diameter and leads away from the plane of the circle. A section between holes has none,
/// and nor has a view without hidden lines of what is behind its faces.
bool shows_circle(const drawing::ViewDrawing& drawing, const MeasuredDimension& measured);

/// Whether a circle has a visible line.
bool shows_visible(const MeasuredCircle& circle);

/// The parts of a circle that a view draws; only the visible ones if there are any. Of a circle through the centres of
/// holes, those between the holes, which have lines along it, too.
class DrawnParts {
 public:
  DrawnParts(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle);

  /// Of directions from the centre, in radians, those in which the circle is drawn. Where it is in none of them, that
  /// of its longest line; all if it has none.
  [[nodiscard]] std::vector<double> among(const std::vector<double>& angles) const;
  [[nodiscard]] bool is_at(double angle) const;

 private:
  const MeasuredCircle& circle_;
  std::vector<std::array<Vec2, 2>> lines_;  ///< from the centre, in lengths of the spokes
  std::vector<Disc> holes_;                 ///< through whose centres it goes
};

}  // namespace epura::sheet
