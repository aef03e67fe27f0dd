// SPDX-License-Identifier: Apache-2.0
// Selects the triangles that may cross others; the rest are excluded from the search for intersection lines.
#pragma once

#include "base/progress.hpp"
#include "edges/intersections.hpp"
#include "world/world.hpp"

namespace epura::edges {

/// Returns the triangles of the world that may cross others. With any other triangle,
/// find_intersections finds, to the last bit, either nothing or copies of lines that come earlier and are drawn
/// instead:
///
/// - The search treats two triangles as separate if no corner of one lies more than `contact` in front of the plane of
///   the other. In a body proved to be convex (convex_bodies.hpp) this holds for any two.
/// - It treats triangles as separate if their boxes do not overlap. This is the case if the boxes of their bodies do
///   not.
/// - Low triangles (is_low) have no plane in which they could be crossed.
///
/// Excluded are low triangles, triangles of convex bodies whose box does not overlap that of any other body, and all
/// but two of coincident triangles: lines that only further copies would add are already drawn. Besides, the triangles
/// of a patch that is a graph over a plane are not compared with each other (graph_patches.hpp). `normalisation` and
/// `contact` are those of find_intersections. Throws OutOfTime.
CrossingCandidates crossing_candidates(const world::World& world, double normalisation, double contact,
                                       const Progress& progress = {});

/// Returns all triangles: the candidates without any shortcut.
CrossingCandidates all_triangles(const world::World& world);

}  // namespace epura::edges
