// SPDX-License-Identifier: Apache-2.0
// Chamfers of hexagons: those at flats that lean against the axes of the world are equal to the ones at the others.
#pragma once

#include <vector>

#include "sizes/automatic.hpp"

namespace epura::sheet {

/// A plane face that is parallel to no axis of the world.
struct HexagonChamfer {
  int bevel;  ///< the number of the first one that is equal to it
  Vec3 point, normal;
  double slack;  ///< between planes that are one

  /// Whether it is the plane through a point with a direction outwards.
  [[nodiscard]] bool is_face(const Vec3& origin, const Vec3& direction) const;
};

/// Those of all models, in the order of their faces.
std::vector<HexagonChamfer> find_hexagon_chamfers(const DimensionSubject& subject);

}  // namespace epura::sheet
