// SPDX-License-Identifier: Apache-2.0
// Positions of axes: along the axes of the world across them, and along slopes.
#pragma once

#include <span>
#include <vector>

#include "sizes/planning.hpp"

namespace epura::sheet {

/// The positions of equal features with parallel axes across these: along axes of the world in the view that sees them
/// come towards it, `along` if it shows the direction; along the own axes of a turned part; along a slope on the face
/// on which they begin. Others are askew.
Planned positions_of(const Planning& plan, std::span<const Vec3> centres, const Vec3& axis,
                     const NamedProjection* along, int group);

/// Each place along a slope once, from the end of its face.
std::vector<scene::DimensionDescription> slanted_dimensions(const Planning& plan, std::span<const SlantedPlace> places);

}  // namespace epura::sheet
