// SPDX-License-Identifier: Apache-2.0
// What the faces of a part belong to that has sizes of its own.
#pragma once

#include <vector>

#include "features/part_features.hpp"
#include "world/placed_part.hpp"

namespace epura::features {

enum class OwnerKind : unsigned char { none, letter, hole, slot, hexagon, bevel };

struct FaceOwner {
  OwnerKind kind = OwnerKind::none;
  int number = -1;  ///< of a hole, slot, hexagon or bevel in PartFeatures
};

/// By face of one model. Only plane faces, and walls of letters, have an owner.
std::vector<FaceOwner> owners_of_faces(const world::World& world, int model, const world::PlacedPart& part,
                                       const PartFeatures& features);

}  // namespace epura::features
