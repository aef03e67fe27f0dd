// SPDX-License-Identifier: Apache-2.0
// Values, models and points with which a projection is tested.
#pragma once

#include <array>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// A model that is neither a cube nor at the origin.
inline Box probe_box() { return {{-1, -2, 0.5}, {3, 1, 4}}; }

/// Nothing, a point, huge, tiny, and small but far from the origin.
std::vector<Box> extreme_boxes();

/// Values to try for a parameter, all within its range; a projection may refuse some of them.
std::vector<std::vector<double>> probe_values(const Parameter& parameter);

/// Every choice; of other parameters the ends of the range that are finite.
std::vector<std::vector<double>> end_values(const Parameter& parameter);

/// The corners of the box; those not in front of the viewer are moved straight to the plane.
std::array<Vec3, 8> points_before_viewer(const Projection& projection, const Box& box);

}  // namespace epura::projection
