// SPDX-License-Identifier: Apache-2.0
// Where lines parallel to an axis run through the material of a body.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "world/world.hpp"

namespace epura::edges {

/// An axis in the world; heights are along it from its origin.
struct BodyAxis {
  Vec3 origin, direction;  ///< the direction has length 1
};

class MaterialAlong {
 public:
  /// Of the body of a triangle; for lines at least `radius` from the axis.
  MaterialAlong(const world::World& world, int model, int triangle, const BodyAxis& axis, double radius);

  /// The heights between which the line through a point is in the material, ascending. Nothing if that is uncertain:
  /// the line enters a body that is not closed without leaving it.
  [[nodiscard]] std::optional<std::vector<std::array<double, 2>>> at(const Vec3& point) const;

 private:
  BodyAxis axis_;
  Vec3 u_, v_;                                ///< perpendicular to the axis
  std::vector<std::array<Vec3, 3>> corners_;  ///< of triangles: along u, along v, height
};

/// Whether a height is between two of them.
bool holds(const std::vector<std::array<double, 2>>& spans, double height);

}  // namespace epura::edges
