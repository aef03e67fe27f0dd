// SPDX-License-Identifier: Apache-2.0
// Whether polygons together cover a square.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::verify {

/// The corners of a convex polygon, in either direction.
using ConvexPolygon = std::vector<Vec2>;

/// Returns the area of the square from (-1, -1) to (1, 1) that none of the polygons covers, 0 to 4.
double uncovered(const std::vector<ConvexPolygon>& polygons);

}  // namespace epura::verify
