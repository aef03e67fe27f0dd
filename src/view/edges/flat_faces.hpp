// SPDX-License-Identifier: Apache-2.0
// Finds faces of many coplanar triangles: these do not cross each other, even if their boxes overlap.
#pragma once

#include <span>
#include <vector>

#include "world/world.hpp"

namespace epura::edges {

/// Returns for each of the triangles, which are in ascending order, the number of the large flat face to which it
/// belongs, or -1; empty if there is no such face. The triangles of a face are connected by their sides, and their
/// corners lie within `contact` of a plane. `points` are those of the world, in the same unit as `contact`.
std::vector<int> flat_faces(const world::World& world, std::span<const Vec3> points, double contact,
                            const std::vector<int>& triangles);

}  // namespace epura::edges
