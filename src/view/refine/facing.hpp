// SPDX-License-Identifier: Apache-2.0
// Which way triangles face, as their surfaces tell.
//
// Near the contour of a surface, its triangles are seen edge-on, and on the page rounding or a chord across the contour
// decides how they turn. The surface knows: triangles of cylinders and cones that do not reach across the contour
// (refine_world.hpp) turn as their surface does, however low they are. Those of a cut turn as the whole cut face does.
#pragma once

#include <vector>

#include "projection/projection.hpp"
#include "world/world.hpp"

namespace epura::refine {

/// Returns for each triangle of a model 1 if it turns counterclockwise on the page, -1 if clockwise, and 0 if the page
/// must tell. Empty for models without recognised cylinders and cones.
std::vector<signed char> facing_by_surface(const world::Placed& placed, const projection::Projection& projection);

}  // namespace epura::refine
