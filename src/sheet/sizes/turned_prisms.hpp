// SPDX-License-Identifier: Apache-2.0
// Rectangular holes, pockets and bosses that are turned against the world about one of its axes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "features/turned_part.hpp"
#include "sizes/anchors.hpp"
#include "sizes/automatic.hpp"

namespace epura::sheet {

struct TurnedPrism {
  int model;
  Vec3 centre, axis;             ///< the axis is one of the world
  std::array<Vec3, 2> normals;   ///< of its sides; unit, perpendicular to the axis and to each other
  std::array<double, 2> widths;  ///< along these
  bool inwards;                  ///< the material is outside

  /// Half of its size along a direction.
  [[nodiscard]] double reach(const Vec3& direction) const;
  /// Whether a plane is one of its sides.
  [[nodiscard]] bool has_side(const Vec3& point, const Vec3& normal) const;
  /// Whether a line from one point to another runs along a normal, in a side or in the middle between the two.
  [[nodiscard]] bool is_beside(const Vec3& from, const Vec3& to, std::size_t side) const;
};

/// Whether the sides of a prism are along the own axes of a turned part.
bool has_directions_of(const features::TurnedPart& part, const TurnedPrism& prism);
/// Whether a prism is the whole of it.
bool is_ended_by(const features::TurnedPart& part, const TurnedPrism& prism);

/// Two pairs of plane faces that look at each other, or away from each other, across one middle.
std::vector<TurnedPrism> find_turned_prisms(const features::PartFeatures& features);

/// Whether one note can give the widths of both.
bool are_equal(const TurnedPrism& a, const TurnedPrism& b);

/// Whether a dimension is the width of a prism along one of its normals, or the angle between one and an axis of the
/// world.
bool is_width_of(const AnchoredDimension& dimension, const TurnedPrism& prism, std::size_t side);
bool is_angle_of(const AnchoredDimension& dimension, const TurnedPrism& prism);

}  // namespace epura::sheet
