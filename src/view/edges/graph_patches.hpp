// SPDX-License-Identifier: Apache-2.0
// Finds parts of smooth surfaces that do not cross themselves, so that their triangles need not be compared.
#pragma once

#include <span>
#include <vector>

#include "world/world.hpp"

namespace epura::edges {

/// Returns for each of the triangles, which are in ascending order, the number of the patch to which it belongs, or -1;
/// empty if there is no patch. No two triangles of a patch cross. `points` are those of the world, of about unit size;
/// `contact` is a length in the same unit. Triangles with a number from 0 in `taken`, unless that is empty, are in
/// none.
///
/// A patch is a graph over one of the coordinate planes. Let every triangle of it face the same side of that plane, by
/// 35 degrees or more. Then the number of its triangles over a point of the plane is the winding number of its boundary
/// around that point: each triangle adds 1 where it lies, and sides of two triangles cancel. Let the boundary on the
/// plane consist of loops that stay apart from themselves and each other, except that corners may touch without
/// crossing. Then each loop has the winding number 0 or 1, or 0 or -1 if it turns clockwise. If only one turns
/// counterclockwise, the sum is at most 1: no two triangles lie over the same point. Neither connectedness nor
/// manifoldness is needed. (Volino, Magnenat-Thalmann. Efficient self-collision detection on smoothly discretized
/// surface animations using geometrical shape regularity. CGF 1994.)
///
/// Parts of boundaries count as apart if their distance is greater than `contact`, beside which rounding is small;
/// without contact there are no patches.
std::vector<int> graph_patches(const world::World& world, std::span<const Vec3> points, double contact,
                               const std::vector<int>& triangles, const std::vector<int>& taken);

}  // namespace epura::edges
