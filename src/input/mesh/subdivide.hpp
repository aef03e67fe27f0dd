// SPDX-License-Identifier: Apache-2.0
// Rounds coarse meshes by Loop's scheme (Loop: Smooth subdivision surfaces based on triangles, 1987), with the rules of
// Hoppe et al. for sharp edges (Piecewise smooth surface reconstruction, 1994): a character of a few hundred faces has
// smooth outlines.
#pragma once

#include "base/progress.hpp"
#include "mesh/mesh.hpp"

namespace epura::mesh {

/// Divides every triangle into four, `steps` times. Vertices keep their numbers, and those of new ones follow. Edges
/// with one triangle or more than two, between bodies, and those folded by `sharp` degrees or more stay sharp, and so
/// do the vertices where three of them meet. Wires are divided with the mesh. Throws OutOfTime.
Mesh subdivide(Mesh mesh, int steps, double sharp, const Progress& progress = {});

}  // namespace epura::mesh
