// SPDX-License-Identifier: Apache-2.0
// What each face of a part borders on.
#pragma once

#include <vector>

#include "world/world.hpp"

namespace epura::features {

/// A border of a face.
struct FaceBorder {
  int other;     ///< the face behind it
  bool tangent;  ///< both have one plane there
};

/// By face of a model whose part is recognised, in the order of its borders; without open ends.
std::vector<std::vector<FaceBorder>> borders_of_faces(const world::Placed& placed);

}  // namespace epura::features
