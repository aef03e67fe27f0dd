// SPDX-License-Identifier: Apache-2.0
// Proves that a surface is a height field in the view, so that it hides none of its own edges.
#pragma once

#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"

namespace epura::visibility {

/// Whether no two triangles of the view share more on the page grid than a corner or a side. Then find_hidden finds
/// nothing, to the last bit: where the line of an edge runs through a triangle other than its own, it does so entirely
/// beyond one end of the edge, which integers decide. Depth and contact have no influence.
///
/// It is so if all of this holds on the grid, in integers:
/// - every triangle has an area; no side has more than two triangles, and two lie on opposite sides;
/// - sides with only one triangle form closed lines that neither cross nor touch, so every place is covered as often as
///   they wind around it; and exactly one of these lines has the same sense as the triangles, the others are holes.
/// Then no place is covered twice. The test requires that nothing is clipped and that there are no intersection lines.
bool is_height_field(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn);

}  // namespace epura::visibility
