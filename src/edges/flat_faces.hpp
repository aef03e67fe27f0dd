// SPDX-License-Identifier: Apache-2.0
// Faces of many coplanar triangles: these do not cross each other, however their boxes overlap.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace epura::edges {

/// For each of the triangles, which ascend, the number of the large flat face that it is part of, or -1; empty if there
/// is no such face. Its triangles hang together by their sides, and their corners lie within `contact` of a plane.
/// `points` are the world's, where `contact` is measured.
std::vector<int> flat_faces(const scene::World& world, std::span<const Vec3> points, double contact,
                            const std::vector<int>& triangles);

}  // namespace epura::edges
