// SPDX-License-Identifier: Apache-2.0
// A part that is turned against the world about one of its axes, and its own axes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "features/part_features.hpp"

namespace epura::features {

/// The axis of the world that is square to a direction, 0 to 2; -1 if none is.
int axis_beside(const Vec3& normal);

/// Along each axis of the world, whether a plane face is at the lower and at the upper end of the models.
using FlatEnds = std::array<std::array<bool, 2>, 3>;

/// It ends at plane faces along two axes of its own across the axis of the world about which it is turned.
struct TurnedPart {
  Vec3 axis;
  std::array<Vec3, 2> directions;                          ///< unit, perpendicular to the axis and to each other
  std::array<std::array<const PlaneFeature*, 2>, 2> ends;  ///< along each, at its beginning and its end
};

/// Of faces that are perpendicular to no axis of the world, to which it refers. Nothing if a plane face ends the part,
/// which has `points`, along another axis of the world.
std::optional<TurnedPart> find_turned_part(const std::vector<PlaneFeature>& inclined, const std::vector<Vec3>& points,
                                           const FlatEnds& flat);

}  // namespace epura::features
