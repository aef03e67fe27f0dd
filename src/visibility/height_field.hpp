// SPDX-License-Identifier: Apache-2.0
// Proof that a surface is a height field in the view, so that it hides none of its own edges.
#pragma once

#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"

namespace epura::visibility {

/// Whether no two triangles of the view have more in common on the page grid than the corner or side that they share.
/// Then find_hidden finds nothing, to the last bit: the line of an edge that runs through a triangle other than its own
/// does so wholly before the edge or wholly behind it, and whole numbers say so. Depth and contact play no part.
///
/// It is so when all this holds on the grid, in whole numbers:
/// - every triangle has an area; two that share a side lie on either side of it; no side has more than two;
/// - sides of one triangle form closed lines that neither cross nor touch, so every place is covered as often as they
///   run around it; and only one of them runs around its inside like the triangles, the others are holes.
/// So no place is covered twice. Nothing is clipped, and there are no intersection lines.
bool is_height_field(const scene::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn);

}  // namespace epura::visibility
