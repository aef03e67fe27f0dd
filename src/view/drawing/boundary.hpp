// SPDX-License-Identifier: Apache-2.0
// The boundary of a detail view, and what lies inside it. Lengths in mm on paper.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/vec.hpp"

namespace epura::drawing {

/// A circle, or an upright rectangle; points on it are inside.
struct Boundary {
  Vec2 centre;
  Vec2 half;  ///< half its size; of a circle, the radius twice
  bool round;

  bool operator==(const Boundary&) const = default;
};

/// Returns the parameters, ascending from 0 to 1, of the part of a straight line that is inside; nothing if the line is
/// outside or only touches the boundary.
std::optional<std::array<double, 2>> part_inside(const Boundary& boundary, const Vec2& from, const Vec2& to);

/// Returns the part of an area (even-odd rule) that is inside: the point of the boundary or the inside that is nearest
/// to each point of its outline. Arcs along a circle have corners on it, and chords that are less than 0.0001 mm off.
std::vector<std::vector<Vec2>> area_inside(const Boundary& boundary, const std::vector<std::vector<Vec2>>& rings);

/// Returns twice the signed area of a polygon: positive if its corners are in counterclockwise order.
double twice_area(const std::vector<Vec2>& ring);

/// A part of a circle, from one angle to another, counterclockwise in radians.
struct AngleRange {
  double from, to;
};

/// Returns the parts of a circle that are inside: the whole circle once, or arcs between points of the boundary.
std::vector<AngleRange> circle_inside(const Boundary& boundary, const Vec2& centre, double radius);

}  // namespace epura::drawing
