// SPDX-License-Identifier: Apache-2.0
// Directions of holes around an axis: on pitch circles, and radial ones.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "features/part_features.hpp"

namespace epura::sheet {

/// Equal holes whose axes meet that of a round part, all at one angle.
struct RadialPattern {
  Vec3 centre, axis;                                ///< where that of the first hole meets the axis, a unit vector
  std::vector<const features::HoleFeature*> holes;  ///< one or more
  bool is_slanted;                                  ///< whether they are not perpendicular to the axis

  /// From the centre along the axis, and along a hole. Only of slanted ones.
  [[nodiscard]] std::array<Vec3, 2> legs(const features::HoleFeature& hole) const;
};

/// Those whose axes are not all parallel, and perpendicular ones that are along no axis of the world. A hole is in one
/// pattern at most.
std::vector<RadialPattern> find_radial_patterns(const features::PartFeatures& features);

/// Directions of holes about an axis.
struct HoleDirections {
  Vec3 centre, axis;                                ///< the axis is a unit vector
  std::vector<const features::HoleFeature*> holes;  ///< one or more
  std::vector<Vec3> directions;                     ///< of each: unit, perpendicular to the axis
  double reach;                                     ///< of the holes from the axis
  /// Directions of centre lines, perpendicular to the axis and to each other: axes of the world, own ones of a turned
  /// part, or one of the world and the slope across the axis; nothing if the axis is perpendicular to none.
  std::optional<std::array<Vec3, 2>> cross;

  /// The direction of a centre line, either way, that is nearest to that of a hole.
  [[nodiscard]] Vec3 nearest_line(const Vec3& direction) const;
  [[nodiscard]] bool is_on_line(const Vec3& direction) const;
  /// Whether they divide the turn evenly.
  [[nodiscard]] bool are_even() const;
  /// Those that need an angle from a centre line, as numbers: of evenly spaced ones at most one, any of which may have
  /// it; none if a hole, or the middle between two, is on such a line. Of several in one direction, the first.
  [[nodiscard]] std::vector<std::size_t> needed() const;
  /// Whether two of them are at one angle from the nearest centre line, which one dimension gives: "8× 30°".
  [[nodiscard]] bool are_alike(std::size_t a, std::size_t b) const;
};

/// The direction across an axis, along the face on which a feature begins, that is no axis of the world; nothing if the
/// axis is along one of the world, or perpendicular to none.
std::optional<Vec3> slanted_across(const Vec3& axis);

/// `own`: across the axis, in a part that is turned about it.
using OwnDirections = std::optional<std::array<Vec3, 2>>;
HoleDirections directions_of(const RadialPattern& pattern, const OwnDirections& own);
/// Of the holes on a pitch circle; `number` is its index.
HoleDirections directions_of(const features::PartFeatures& features, int number, const OwnDirections& own);

}  // namespace epura::sheet
