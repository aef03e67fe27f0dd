// SPDX-License-Identifier: Apache-2.0
// Screw threads as in ISO 6410-1: crests are the outlines of their cylinders, roots are narrow lines, in a view along
// the axis about three quarters of a circle, and a wide line ends the useful length.
#pragma once

#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

/// Adds the lines of threads in orthographic views along and across their axes; other views show the cylinders alone.
/// Roots are at least `depth` from the crests; threads that are too small for that have no lines. Lines lie where they
/// are seen: those of shafts on the surface towards the viewer, those of holes in the plane of the axis, which a
/// section through it shows.
void add_thread_lines(const scene::World& world, view::ProjectedScene& view, double depth, FeatureEdges& drawn);

}  // namespace epura::edges
