// SPDX-License-Identifier: Apache-2.0
// Finds the two sides of grooves, ribs, pockets and bosses among plane faces that are perpendicular to a world axis.
#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"
#include "features/part_features.hpp"
#include "features/plane_faces.hpp"

namespace epura::features {

/// A plane face that is perpendicular to an axis of the world.
struct AxialFace {
  int model, body, axis;
  bool is_high;  ///< it looks along the axis; otherwise against it
  double at;     ///< along the axis
  Box box;       ///< of its corners
};

std::vector<AxialFace> find_axial_faces(int model, std::span<const PlaneFace> faces);

/// Gives each level, sorted by axis and place, of those that are one side of a groove or rib, the place of the other
/// side. The two sides look at each other, or away from each other, and are one behind the other: alike along one axis
/// across, and with one end in common along the other; or both end a cylinder, the neck of a shaft. Narrow ones go
/// first, and a place is the side of one of them.
std::vector<LevelFeature> with_opposite_sides(std::vector<LevelFeature> levels, std::span<const AxialFace> faces,
                                              std::span<const CylinderFeature> cylinders, double slack);

}  // namespace epura::features
