// SPDX-License-Identifier: Apache-2.0
// Screw threads as in ISO 6410-1: crests are the outlines of their cylinders, roots are narrow lines, in a view along
// the axis about three quarters of a circle, and a wide line ends the useful length. There, circles of chamfers are
// left out.
#pragma once

#include <compare>
#include <vector>

#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

/// An edge of a mesh.
struct MeshEdgeOfModel {
  int model, mesh_edge;
  auto operator<=>(const MeshEdgeOfModel&) const = default;
};

/// Returns, in ascending order, the edges at the far ends of chamfers that are as deep as their threads and seen along
/// the axis.
std::vector<MeshEdgeOfModel> chamfer_circles(const world::World& world, const projection::Projection& projection,
                                             double depth);

/// Adds the lines of threads in orthographic views along and across their axes; other views show the cylinders alone.
/// Roots are at least `depth` from the crests; threads that are too small for that have no lines. Lines lie where they
/// are seen: those of shafts on the surface towards the viewer, those of holes in the plane of the axis, which a
/// section through it shows. They end where keyways, flats and other holes interrupt the thread. The edges of
/// `chamfer_circles` are removed.
void add_thread_lines(const world::World& world, view::ProjectedScene& view, double depth, FeatureEdges& drawn);

}  // namespace epura::edges
