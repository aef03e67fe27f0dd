// SPDX-License-Identifier: Apache-2.0
// Planar polygons with holes -> triangles on the same corners, so that neighbouring faces still meet edge to edge.
#pragma once

#include <array>
#include <vector>

#include "solid.hpp"

namespace samples {

/// Ear clipping, shortest diagonal first, after each hole was joined to the outline by its shortest bridge.
/// `outer` runs counter-clockwise about `normal`, holes the other way. Throws std::logic_error when loops cross.
std::vector<std::array<int, 3>> triangulate(const std::vector<Point>& points, std::vector<int> outer,
                                            std::vector<std::vector<int>> holes, const Point& normal);

}  // namespace samples
