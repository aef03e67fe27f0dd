// SPDX-License-Identifier: Apache-2.0
// Spline surfaces that are simple surfaces: many programs write all of their surfaces as splines.
#pragma once

#include <Geom_Surface.hxx>
#include <array>

namespace occt {

/// First and last parameter along u, first and last along v.
using Range = std::array<double, 4>;

/// The plane, cylinder, cone, sphere or torus with which the surface coincides in this range, or none. Its lines of
/// constant u and v determine the candidate; points all over the range verify it.
Handle(Geom_Surface) canonical(const Geom_Surface& surface, const Range& range);

}  // namespace occt
