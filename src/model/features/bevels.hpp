// SPDX-License-Identifier: Apache-2.0
// Finds the plane faces that are parallel to one axis of the world only: chamfered corners and slopes.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "features/part_features.hpp"
#include "features/plane_faces.hpp"
#include "world/placed_part.hpp"

namespace epura::features {

/// The faces of one model.
struct ModelFaces {
  const world::World& world;
  int model;
  const world::PlacedPart& part;
  const std::vector<PlaneFace>& planes;                 ///< by face
  const std::vector<std::vector<FaceBorder>>& borders;  ///< by face
};

/// Slopes with an edge along their axis at both ends, to another plane or to an arc that is tangent to both, by their
/// faces; without those that belong to something else and those between two other slopes.
std::vector<BevelFeature> find_bevels(const ModelFaces& faces, const std::function<bool(std::size_t)>& is_other);

}  // namespace epura::features
