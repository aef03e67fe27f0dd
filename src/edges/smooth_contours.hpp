// SPDX-License-Identifier: Apache-2.0
// Contours of curved faces where the surface has them, and not where facets do.
//
// The contour of a polyhedron tells rightly which side is seen, and jumps between the edges of its facets. So what is
// hidden stays with the edges of the mesh, and their ends are drawn on the contour of the surface: where normals of the
// surface are square to the projectors (Hertzmann, Zorin: Illustrating smooth surfaces, SIGGRAPH 2000).
#pragma once

#include "edges/find_edges.hpp"

namespace epura::edges {

/// Sets FeatureEdge::shown of contours inside recognised spheres, tori and free forms, and notes how far that moved
/// ink. Ends on sharp edges of the part stay where they are, and so do straight contours, of cylinders and cones. The
/// view gets the vertices for it.
void smooth_contours(const scene::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                     FeatureEdges& drawn);

}  // namespace epura::edges
