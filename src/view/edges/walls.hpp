// SPDX-License-Identifier: Apache-2.0
// Finds faces of a part that are seen edge-on, such as walls from above.
//
// Which way their facets face is decided by rounding, in the file and in the modeller. So all edges of such a face take
// it for a line on the page: none of them asks its own facets.
#pragma once

#include <vector>

#include "edges/dihedral.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

/// Returns for each face of the part of a model whether all of its facets are lines on the page, but for the resolution
/// of the page and the distance of vertices from the surface of the face. Empty if no faces are known.
std::vector<char> walls(const EdgeSurroundings& around, const view::ProjectedScene& view);

}  // namespace epura::edges
