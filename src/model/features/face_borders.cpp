// SPDX-License-Identifier: Apache-2.0
#include "features/face_borders.hpp"

#include <cstddef>

#include "base/error.hpp"

namespace epura::features {

std::vector<std::vector<FaceBorder>> borders_of_faces(const world::Placed& placed) {
  check(placed.part != nullptr, "a model has faces if its part is recognised");
  std::vector<std::vector<FaceBorder>> beside(placed.part->faces.size());
  for (const surfaces::PartBorder& border : placed.part->borders) {
    const auto [a, b] = border.faces;
    if (a < 0 || a == b) continue;
    const bool tangent = border.kind == surfaces::BorderKind::tangent;
    beside[static_cast<std::size_t>(a)].push_back({b, tangent});
    beside[static_cast<std::size_t>(b)].push_back({a, tangent});
  }
  return beside;
}

}  // namespace epura::features
