// SPDX-License-Identifier: Apache-2.0
// Divides polygons into triangles with the same corners and the same signed area.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "mesh/faces.hpp"

namespace epura::mesh {

struct Triangulation {
  Faces triangles;
  /// Numbers in the file of faces that cross themselves or are so intricate that the search for ears was given up: some
  /// of their triangles may lie outside.
  std::vector<int> unfinished{};
};

/// Divides every face into triangles with the same number and orientation: a fan if all corners are visible from the
/// first one, otherwise ears clipped in a coordinate plane chosen by the Newell normal. A triangle that would contain
/// one vertex twice is omitted. Throws OutOfTime.
Triangulation triangulate(Faces faces, const Points& points, const Progress& progress = {});

}  // namespace epura::mesh
