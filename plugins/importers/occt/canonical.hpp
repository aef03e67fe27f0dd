// SPDX-License-Identifier: Apache-2.0
// Surfaces of splines that are simple ones: many programs write all of their surfaces so.
#pragma once

#include <Geom_Surface.hxx>
#include <array>

namespace occt {

/// First and last parameter along u, first and last along v.
using Range = std::array<double, 4>;

/// The plane, cylinder, cone, sphere or torus that the surface is in this range, or none. Its lines of constant u and v
/// tell the candidate, points all over the range whether it is that.
Handle(Geom_Surface) canonical(const Geom_Surface& surface, const Range& range);

}  // namespace occt
