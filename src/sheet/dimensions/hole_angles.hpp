// SPDX-License-Identifier: Apache-2.0
// Angles of holes around an axis: on pitch circles, and radial ones. Centre lines show the directions of the axes of
// the world; evenly spaced holes have one angle for all (ISO 129-1).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sheet/dimensions/anchors.hpp"
#include "sheet/dimensions/planning.hpp"

namespace epura::sheet {

/// Equal holes whose axes meet that of a round part, perpendicular to it.
struct RadialPattern {
  Vec3 axis;                                     ///< of the part; unit
  std::vector<const design::DesignHole*> holes;  ///< two or more
};

/// Those whose axes are not all parallel. A hole is in one pattern at most.
std::vector<RadialPattern> find_radial_patterns(const design::DesignFeatures& features);

/// Directions of holes about an axis of the world.
struct HoleDirections {
  Vec3 centre, axis;                             ///< the axis is a unit vector
  std::vector<const design::DesignHole*> holes;  ///< two or more
  std::vector<Vec3> directions;                  ///< of each: unit, perpendicular to the axis
  double reach;                                  ///< of the holes from the axis

  /// Whether they divide the turn evenly.
  [[nodiscard]] bool are_even() const;
  /// Those that need an angle from an axis of the world, as numbers: of evenly spaced ones at most one, any of which
  /// may have it; none if a hole, or the middle between two, is on such an axis.
  [[nodiscard]] std::vector<std::size_t> needed() const;
  /// Whether two of them are at one angle from the nearest axis of the world, which one dimension gives: "8× 30°".
  [[nodiscard]] bool are_alike(std::size_t a, std::size_t b) const;
};

HoleDirections directions_of(const RadialPattern& pattern);
/// Of the holes on a pitch circle; `number` is its index.
HoleDirections directions_of(const design::DesignFeatures& features, int number);

/// Adds the angles that are needed, between axes of the world and holes, and the step of evenly spaced radial ones.
void add_angles(Planning& plan, const HoleDirections& around, bool with_step);

/// Whether an angle about the same axis has a leg in the direction of a hole, or of one that is alike if it counts
/// several.
bool gives_direction(const AnchoredDimension& dimension, const HoleDirections& around, std::size_t number);

}  // namespace epura::sheet
