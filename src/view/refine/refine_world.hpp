// SPDX-License-Identifier: Apache-2.0
// Splits facets of cylinders and cones along their contours in a view, so that the mesh says what the surface says
// before anything is hidden.
#pragma once

#include <optional>
#include <vector>

#include "projection/projection.hpp"
#include "world/world.hpp"

namespace epura::refine {

/// A world, and what refinement left of its triangles.
struct RefinedWorld : world::World {
  std::vector<int> kept;  ///< by triangle: its number before; -1 unless it and those beside it are as they were
};

/// Returns the world with the contours of its recognised cylinders and cones among the edges of its meshes, or nothing
/// if no facet must be split for that. New vertices lie on the surfaces, and on both at the border of two; they follow
/// those of the file as vertices of a cut do (mesh::CutVertex), so edges and faces keep their names. The box of the
/// world stays as it is. What a plane has cut ends in that plane, to within what the surface rises over a facet.
std::optional<RefinedWorld> refine_world(const world::World& world, const projection::Projection& projection);

}  // namespace epura::refine
