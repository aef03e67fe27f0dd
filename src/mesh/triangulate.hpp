// SPDX-License-Identifier: Apache-2.0
// Polygons -> triangles with the same corners and the same signed area.
#pragma once

#include "base/progress.hpp"
#include "mesh/faces.hpp"

namespace epura::mesh {

/// Every face as triangles that keep its number and direction: a fan where its first corner sees all others, ears cut
/// off in the plane of the Newell normal otherwise. A triangle that would name one vertex twice is left out.
/// Throws OutOfTime.
Faces triangulate(Faces faces, const Points& points, const Progress& progress = {});

}  // namespace epura::mesh
