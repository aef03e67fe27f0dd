// SPDX-License-Identifier: Apache-2.0
// The edges of a world as a page draws them: without knowing which are hidden.
#pragma once

#include <string>

#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"
#include "world/world.hpp"

namespace epura {

/// Returns three whole numbers of 32 bits and a zero: how many vertices there are, edges that every view has, and other
/// edges, which a view has as contours; then the vertices, three doubles each; then the edges that every view has, two
/// vertices each; then the others, with the third corners of their two triangles. Numbers are those of this machine,
/// where the page is shown.
std::string wireframe_bytes(const world::World& world, const view::ProjectedScene& any_view,
                            const edges::EdgeOptions& edges);

}  // namespace epura
