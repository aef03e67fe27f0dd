// SPDX-License-Identifier: Apache-2.0
// Splits a triangle at points on its sides.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"

namespace epura::refine {

/// A corner of a triangle, or a point on one of its sides.
struct RingPoint {
  int vertex;
  Vec2 in_triangle;  ///< the corners are (0, 0), (1, 0) and (0, 1)
  Vec3 place;        ///< in space, which may be beside the side
  int side;          ///< of the contour: 1 in front, -1 behind, 0 on it
};

/// Returns the triangles between the points around a triangle, which turn as it does. If two points that are not
/// neighbours are on the contour, no triangle reaches across it.
std::vector<std::array<int, 3>> split_triangle(const std::vector<RingPoint>& ring);

}  // namespace epura::refine
