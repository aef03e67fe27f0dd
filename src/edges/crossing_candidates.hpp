// SPDX-License-Identifier: Apache-2.0
// Which triangles may cross others at all; the rest are excluded from the search for intersection lines.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "scene/scene.hpp"

namespace epura::edges {

/// Triangles of the world that may cross, ascending. With the others find_intersections finds nothing, to the last bit,
/// or copies of lines that come before them and so are drawn in their place:
///
/// - The search takes two triangles as apart when no corner of one lies more than `contact` before the plane of the
///   other. In a body proved to be convex (convex_bodies.hpp) that holds for any two.
/// - It takes triangles as apart when their boxes are. So they are where those of their bodies are.
/// - Low triangles (is_low) have no plane to be crossed in.
///
/// Left out are low triangles, those of convex bodies whose box meets that of no other body, and of copies of a
/// triangle in one place all but two: lines that only others would add are drawn already. `normalisation` and
/// `contact` are those of find_intersections. Throws OutOfTime.
std::vector<int> crossing_candidates(const scene::World& world, double normalisation, double contact,
                                     const Progress& progress = {});

/// Without shortcuts: all triangles.
std::vector<int> all_triangles(const scene::World& world);

}  // namespace epura::edges
