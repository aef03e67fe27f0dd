// SPDX-License-Identifier: Apache-2.0
// Draws contours of curved faces on the surface instead of on its facets.
//
// The contour of a polyhedron separates its visible from its hidden side correctly, but jumps between the edges of its
// facets. So visibility is decided with the edges of the mesh, whose ends are drawn on the contour of the surface,
// where its normals are perpendicular to the projectors (Hertzmann, Zorin: Illustrating smooth surfaces, SIGGRAPH
// 2000).
#pragma once

#include "edges/find_edges.hpp"

namespace epura::edges {

/// Sets FeatureEdge::shown, by_chance and hollow for contours inside recognised round surfaces and free forms,
/// by_chance also around single facets that the tessellation turned over, and records how far this moved ink. Ends on
/// sharp edges of the part stay unchanged. Contours of cylinders and cones are edges of the mesh already
/// (refine/refine_world.hpp). The vertices needed are added to the view.
void smooth_contours(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                     FeatureEdges& drawn);

}  // namespace epura::edges
