// SPDX-License-Identifier: Apache-2.0
// The recognised faces of a model in world coordinates.
#pragma once

#include <optional>
#include <vector>

#include "world/world.hpp"

namespace epura::world {

using surfaces::similarity_scale;

struct PlacedPart {
  std::vector<surfaces::PartFace> faces;  ///< lengths and positions in the world
  std::vector<int> face_of_triangle;      ///< face of each of the model's triangles in the world; -1: none
  double tolerance;                       ///< as in PartFaces, in units of the world
};

/// Returns nothing if no faces are recognised, or if a non-uniform scale changes the kind of their surfaces. For a cut
/// model, the triangles are those of the remainder, the faces those of the uncut part.
std::optional<PlacedPart> place_part(const Placed& placed);

/// Returns for each face of the file its face of the part; -1 if it has none.
std::vector<int> faces_of_polygons(const Placed& placed);

/// Returns for each triangle of a model, which may be cut, its face of the part; -1 if it has none.
std::vector<int> faces_of_triangles(const Placed& placed);

inline bool is_round(surfaces::SurfaceKind kind) {
  return kind != surfaces::SurfaceKind::plane && kind != surfaces::SurfaceKind::free_form;
}

}  // namespace epura::world
