// SPDX-License-Identifier: Apache-2.0
// Moves the outlines of a cut from the facets onto the surfaces that the facets represent.
#pragma once

#include "cut/cut_mesh.hpp"
#include "cut/cut_outline.hpp"
#include "world/placed_part.hpp"

namespace epura::cut {

/// Moves each vertex that the cut creates on an edge between two triangles: within the plane, onto the recognised
/// surface of both, or to the point where their two surfaces and the plane meet. So outlines stay closed, and faces
/// continue to meet. A vertex stays where the surfaces do not meet the plane near the facets, or if they are free
/// forms. `cut` is fresh from `cut_mesh`, which lists a segment for every triangle. Returns the largest movement, in
/// units of the world.
double move_to_surfaces(CutMesh& cut, const world::World& world, int model, const PlaneFrame& frame);

}  // namespace epura::cut
