// SPDX-License-Identifier: Apache-2.0
// Triangulates areas bounded by outlines with the even-odd rule.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace epura::mesh {

/// The vertices of closed outlines, and segments between them in any order. From a point inside, a ray crosses an odd
/// number of segments.
struct Outlines {
  std::vector<Vec2> places;
  std::vector<std::array<int, 2>> segments;
};

/// Returns triangles that fill the inside without overlap. Their corners are vertices of the outlines, and new points
/// on segments, which are appended to `outlines.places`. Segments may cross and coincide. Lengths far below 1e-12 of
/// the whole size are not resolved.
std::vector<std::array<int, 3>> fill_even_odd(Outlines& outlines);

/// Whether a point lies inside. For points on the outline, either result is possible.
bool is_inside(const Outlines& outlines, const Vec2& point);

}  // namespace epura::mesh
