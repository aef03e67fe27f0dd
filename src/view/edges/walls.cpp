// SPDX-License-Identifier: Apache-2.0
#include "edges/walls.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "view/page_height.hpp"
#include "world/placed_part.hpp"

namespace epura::edges {

std::vector<char> walls(const EdgeSurroundings& around, const view::ProjectedScene& view) {
  const world::Placed& placed = around.world.models[static_cast<std::size_t>(around.model)];
  if (placed.part == nullptr) return {};
  const surfaces::PartFaces& part = *placed.part;
  // Scaled differently in different directions, a surface is not at a known distance.
  const double scale = world::similarity_scale(placed.to_world).value_or(0);
  const double page_per_length = scale * view.map.normalisation * view.map.unit;
  const double resolution = view::page_resolution(around.world, view);
  std::vector<char> are_walls(part.faces.size(), 1);
  const std::vector<int>& faces = part.face_of_triangle;
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const auto face = static_cast<std::size_t>(faces[t]);
    check(face < are_walls.size(), "every triangle is of a face of the part");
    if (are_walls[face] == 0) continue;
    // Both ends of the surface may be off it.
    const double most = resolution + 2 * part.faces[face].residual * page_per_length;
    if (!(view::height_on_page(view, around.corners(static_cast<int>(t))) <= most)) are_walls[face] = 0;
  }
  return are_walls;
}

}  // namespace epura::edges
