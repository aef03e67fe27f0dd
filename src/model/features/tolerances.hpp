// SPDX-License-Identifier: Apache-2.0
// What counts as the same in what a designer made.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.hpp"
#include "features/limits.hpp"

namespace epura::features {

/// Of unit vectors; opposite ones are parallel too.
inline bool are_parallel(const Vec3& a, const Vec3& b) { return glm::length(glm::cross(a, b)) <= parallel; }
/// The axis of the world, 0 to 2, to which a unit vector is parallel; -1 if there is none.
inline int axis_along(const Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction[axis]) >= 1 - parallel * parallel) return axis;
  return -1;
}
inline bool are_same(double a, double b) { return std::abs(a - b) <= same_size * std::max(std::abs(a), std::abs(b)); }

/// How far apart round faces of a size may be that belong together, given the tolerance of their part.
inline double slack_of(double tolerance, double size) { return std::max(together * tolerance, same_size * size); }
/// From the line through a point along a unit vector.
inline double distance_from_line(const Vec3& point, const Vec3& on_line, const Vec3& axis) {
  return glm::length(glm::cross(point - on_line, axis));
}

}  // namespace epura::features
