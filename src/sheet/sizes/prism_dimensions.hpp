// SPDX-License-Identifier: Apache-2.0
// Dimensions of rectangular holes, pockets and bosses that are turned against the world.
#pragma once

#include <string>
#include <vector>

#include "sizes/planning.hpp"

namespace epura::sheet {

/// A straight side from one of its corners.
struct Side {
  Vec3 corner, along;
};

/// The angle between one of several sides of a figure and the axis of the world, across the sight of a view, that is
/// nearest to it: the least one, at the lowest corner. The view looks along an axis of the world.
scene::DimensionDescription angle_to_axis(const Planning& plan, const NamedProjection& view,
                                          const std::vector<Side>& sides, const std::string& text);

/// Whether the size of the models along an axis follows from the sides and the angle of a part that is turned as a
/// whole.
bool is_over_turned_part(const Planning& plan, int axis);

/// Both widths, of equal ones once, the angle to the nearest axis of the world, in a turned part once, and positions.
Planned prism_dimensions(const Planning& plan);

}  // namespace epura::sheet
