// SPDX-License-Identifier: Apache-2.0
// Positions around an axis.
#pragma once

#include <cmath>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
#include "base/vec.hpp"

namespace epura::features {

/// Cylindrical coordinates.
struct AroundAxis {
  Vec3 origin, axis;  ///< the axis is a unit vector
  Vec3 u, v;          ///< unit vectors square to it and to each other

  AroundAxis(const Vec3& point, const Vec3& direction) : origin(point), axis(direction) {
    const Vec3 aside = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    u = glm::normalize(glm::cross(axis, aside));
    v = glm::cross(axis, u);
  }
  [[nodiscard]] double height(const Vec3& p) const { return glm::dot(p - origin, axis); }
  [[nodiscard]] double radius(const Vec3& p) const { return glm::length(glm::cross(p - origin, axis)); }
  /// The part of its position square to the axis.
  [[nodiscard]] Vec3 outwards(const Vec3& p) const { return p - origin - height(p) * axis; }
  /// Its angle, in turns from -1/2 to 1/2.
  [[nodiscard]] double turn(const Vec3& p) const {
    return portable_atan2(glm::dot(p - origin, v), glm::dot(p - origin, u)) / full_turn;
  }
};

}  // namespace epura::features
