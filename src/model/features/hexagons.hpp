// SPDX-License-Identifier: Apache-2.0
// Finds regular hexagons among plane faces: nuts, heads of screws, and sockets.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "features/plane_faces.hpp"

namespace epura::features {

/// Six plane faces, the flats, at one distance from an axis that is parallel to one of the world, and at 60 degrees to
/// one another. Slots, chamfers and rounded edges may have taken parts of them.
struct HexagonFeature {
  int model;
  Vec3 centre;                  ///< on its axis, in the middle of what all flats have of it
  Vec3 axis;                    ///< unit
  std::array<Vec3, 3> normals;  ///< unit, of three flats in a row; the other flats are opposite
  double across_flats;
  double half_flat;             ///< greatest distance of a corner of a flat from the middle of its side
  double half_height;           ///< of what all flats have of the axis
  bool inwards;                 ///< the material is outside: a socket
  std::vector<int> vertices{};  ///< of its flats, in the model's file; ascending

  /// Half of the size of the full hexagon along a direction: across flats, corners, or between.
  [[nodiscard]] double reach(const Vec3& direction) const;
  /// Whether a face with these vertices is one of its flats.
  [[nodiscard]] bool has_flat(const std::vector<int>& face) const {
    return std::includes(vertices.begin(), vertices.end(), face.begin(), face.end());
  }
};

/// The hexagons of one model, body by body.
std::vector<HexagonFeature> find_hexagons(int model, const std::vector<PlaneFace>& faces);

}  // namespace epura::features
