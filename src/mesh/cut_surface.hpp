// SPDX-License-Identifier: Apache-2.0
// Triangles -> an OpenMesh surface, cut open where it would not be an oriented two-manifold.
//
// [Gueziec, Taubin, Lazarus, Horn. Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces.
// IEEE TVCG 7(2), 2001]: two triangles stay joined along an edge that only they share, in opposite directions; then
// the triangles around a vertex fall into fans, and each fan gets a vertex of its own. add_face would refuse the
// triangles that do not fit and takes several times as long, so the surface is laid out in arrays at once.
#pragma once

#include "mesh/edge_table.hpp"
#include "mesh/mesh.hpp"
#include "mesh/soup.hpp"

namespace epura {

/// Fills `mesh.surface` and `mesh.vertex_of`. Triangle t becomes face t, point v becomes vertex v, isolated if no
/// triangle uses it; copies for further fans follow, in the order of their lowest half-edges.
void cut_surface(Mesh& mesh, const Points& points, std::span<const int> corners, const EdgeTable& table);

}  // namespace epura
