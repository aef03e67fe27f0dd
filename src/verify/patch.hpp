// SPDX-License-Identifier: Apache-2.0
// Whether polygons together cover a square.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::verify {

/// A convex polygon, its corners in order, either way round.
using ConvexPolygon = std::vector<Vec2>;

/// The area of the square from (-1, -1) to (1, 1) that none of the polygons covers, 0 to 4.
double uncovered(const std::vector<ConvexPolygon>& polygons);

}  // namespace epura::verify
