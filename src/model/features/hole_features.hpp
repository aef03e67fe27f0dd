// SPDX-License-Identifier: Apache-2.0
// Describes the holes of a model by the sizes that a drawing gives for them.
#pragma once

#include <vector>

#include "features/part_features.hpp"
#include "world/placed_part.hpp"

namespace epura::features {

struct DescribedHoles {
  std::vector<HoleFeature> holes;
  std::vector<CylinderFeature> bores;  ///< of all other holes
};

/// A hole is plain, counterbored or countersunk, and through or blind; what else there is has only bores.
DescribedHoles describe_holes(const world::World& world, int model, const world::PlacedPart& part);

}  // namespace epura::features
