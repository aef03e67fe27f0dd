// SPDX-License-Identifier: Apache-2.0
// The recognised faces of a model in world coordinates.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace epura::scene {

using features::similarity_scale;

struct PlacedPart {
  std::vector<features::PartFace> faces;  ///< lengths and places of the world
  std::vector<int> face_of_triangle;      ///< of the model's triangles in the world; -1 where nothing was recognised
  double tolerance;                       ///< as in PartFaces, a length of the world
};

/// Nothing where no faces are recognised, or a transform with unequal scales has made other surfaces of them. Of a
/// model that was cut the triangles are what is left, the faces are those of the whole.
std::optional<PlacedPart> place_part(const Placed& placed);

/// By triangle of a model, which may have been cut: faces of its part, -1 where there is none.
std::vector<int> faces_of_triangles(const Placed& placed);

inline bool is_round(features::SurfaceKind kind) {
  return kind != features::SurfaceKind::plane && kind != features::SurfaceKind::free_form;
}

}  // namespace epura::scene
