// SPDX-License-Identifier: Apache-2.0
// Whether two bodies have the same shape: the same mesh, turned and moved.
#pragma once

#include <vector>

#include "world/world.hpp"

namespace epura::world {

/// The shape of a body apart from its position, in units of the world.
struct Shape {
  std::vector<Vec3> corners;  ///< of its triangles, each once, from the centre of its area, in order of their numbers
  std::vector<double> reach;  ///< their distances from it, ascending
  std::size_t triangles = 0;
  double area = 0;
  double volume = 0;  ///< signed: positive if faces are oriented outwards; meaningless for open bodies
};

/// The shape of the triangles with these numbers.
Shape shape_of(const World& world, const std::vector<int>& triangles);

/// Whether a rigid motion, not a reflection, takes the corners of one to those of the other within `tolerance`.
/// Triangles are only counted: bodies of the same corners and area with other edges count as equal.
bool are_congruent(const Shape& a, const Shape& b, double tolerance);

}  // namespace epura::world
