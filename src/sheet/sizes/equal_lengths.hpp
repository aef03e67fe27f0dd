// SPDX-License-Identifier: Apache-2.0
// How many equal lengths and angles the faces of models have, for "4×" in texts.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "world/placed_part.hpp"

namespace epura::sheet {

/// The planes and axes of all models; none if there are too many. It refers to what it is given.
class EqualLengths {
 public:
  EqualLengths(const std::vector<std::optional<world::PlacedPart>>& parts, const world::World& world, double slack);

  /// Independent distances of a value between parallel planes and axes.
  [[nodiscard]] int lengths(double value) const;
  /// Between the largest plane and the largest one on the other side of its material; 0 if there is none.
  [[nodiscard]] double thickness() const;
  /// Pairs of planes and axes at an angle to each other, in degrees; cones with it; and axes along `sight` seen from a
  /// corner, with each other and with the centre lines along and across a leg.
  [[nodiscard]] int angles(double value, const Vec3& corner, const Vec3& leg, const Vec3& sight) const;
  /// Planes and cones that rise by a value.
  [[nodiscard]] int slopes(double value) const;
  /// Whether a plane, an axis or a corner is at a place along a direction.
  [[nodiscard]] bool has_place(const Vec3& place, const Vec3& along, double slack) const;

 private:
  struct Face {
    surfaces::PartSurface surface;
    Box box;        // of its corners
    double length;  // along its axis
    double area;    // of its facets
  };
  const world::World& world_;
  double slack_;
  std::vector<Face> faces_;
};

}  // namespace epura::sheet
