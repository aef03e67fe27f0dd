// SPDX-License-Identifier: Apache-2.0
// The plane faces of a part, in the world.
#pragma once

#include <vector>

#include "world/placed_part.hpp"
#include "world/world.hpp"

namespace epura::features {

struct PlaneFace {
  int body;
  Vec3 normal;                  ///< unit, out of the material
  std::vector<Vec3> corners;    ///< without regard to cuts; none for faces of other kinds
  std::vector<int> vertices{};  ///< of the corners in the model's file, ascending
};

/// The faces of one model by their numbers. Those that are parallel to no axis of the world have no corners.
std::vector<PlaneFace> find_plane_faces(const world::World& world, int model, const world::PlacedPart& part);

/// A border of a face.
struct FaceBorder {
  int other;     ///< the face behind it
  bool tangent;  ///< both have one plane there
};

/// By face of a model whose part is recognised, in the order of its borders; without open ends.
std::vector<std::vector<FaceBorder>> borders_of_faces(const world::Placed& placed);

}  // namespace epura::features
