// SPDX-License-Identifier: Apache-2.0
// Values, models and points for tests of a projection.
#pragma once

#include <array>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// A model that is neither a cube nor at the origin.
inline Box probe_box() { return {{-1, -2, 0.5}, {3, 1, 4}}; }

/// An empty box, a point, huge, tiny, and small but far from the origin.
std::vector<Box> extreme_boxes();

/// Returns values to try for a parameter, all within its range; a projection may reject some of them.
std::vector<std::vector<double>> probe_values(const Parameter& parameter);

/// Returns every choice; for other parameters, the finite ends of the range.
std::vector<std::vector<double>> end_values(const Parameter& parameter);

/// Returns the corners of the box; those not in front of the viewer are moved perpendicularly to the plane.
std::array<Vec3, 8> points_before_viewer(const Projection& projection, const Box& box);

}  // namespace epura::projection
