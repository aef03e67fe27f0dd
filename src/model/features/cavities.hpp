// SPDX-License-Identifier: Apache-2.0
// The room inside holes and slots.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "features/part_features.hpp"

namespace epura::features {

/// Within `radius` of the segment between two points, down from there.
struct Cavity {
  std::array<Vec3, 2> centres;  ///< where it begins
  Vec3 axis;                    ///< unit, out of the material
  double radius;
  double reach;  ///< against the axis
  bool is_hole;  ///< otherwise a slot; a plane across the axis of a hole belongs to it
  int number;    ///< in PartFeatures

  [[nodiscard]] bool holds(const Vec3& point) const;
  /// Whether a plane face is part of its wall or floor.
  [[nodiscard]] bool holds(const Vec3& normal, const std::vector<Vec3>& corners) const;
};

/// Those of one model.
std::vector<Cavity> cavities_of(const PartFeatures& features, int model);

/// The first one of which a plane face is part; nothing if there is none.
std::optional<Cavity> cavity_around(const std::vector<Cavity>& cavities, const Vec3& normal,
                                    const std::vector<Vec3>& corners);

}  // namespace epura::features
