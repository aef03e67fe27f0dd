// SPDX-License-Identifier: Apache-2.0
// Holes of a part: round faces around one axis with the material outside.
#pragma once

#include <vector>

#include "features/recognise.hpp"

namespace epura::features {

struct Hole {
  std::vector<int> faces;         ///< round faces around its axis: bores, countersinks, the tip of a drill hole
  std::vector<double> diameters;  ///< of its bores, smallest first
  Vec3 from, to;                  ///< ends of its axis
  bool through;                   ///< open at both ends
};

/// Finds full bores, and joins successive bores on one axis into one hole. Ordered by their lowest face.
std::vector<Hole> find_holes(const mesh::Mesh& mesh, const PartFaces& part);

}  // namespace epura::features
