// SPDX-License-Identifier: Apache-2.0
// Divides polygons into triangles with the same corners and the same signed area.
#pragma once

#include "base/progress.hpp"
#include "mesh/faces.hpp"

namespace epura::mesh {

/// Divides every face into triangles with the same number and orientation: a fan if all corners are visible from the
/// first one, otherwise ears clipped in a coordinate plane chosen by the Newell normal. A triangle that would contain
/// one vertex twice is omitted. Throws OutOfTime.
Faces triangulate(Faces faces, const Points& points, const Progress& progress = {});

}  // namespace epura::mesh
