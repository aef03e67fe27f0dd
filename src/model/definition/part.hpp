// SPDX-License-Identifier: Apache-2.0
// The faces of a part, as the accountant sees them: surfaces, and where they touch. No hole, slot or chamfer.
#pragma once

#include <array>
#include <vector>

#include "surfaces/part_surface.hpp"

namespace epura::definition {

struct Face {
  surfaces::PartSurface surface;
  Vec3 at;          ///< a point about the middle of the face
  double area = 0;  ///< 0: not a face but what is only drawn, as a pitch circle or a plane of symmetry
};

/// Where two faces meet.
struct Contact {
  std::array<int, 2> faces;
  std::vector<Vec3> points;  ///< along their common border
  bool is_tangent = false;
};

struct Part {
  std::vector<Face> faces;
  std::vector<Contact> contacts{};
  double size = 1;  ///< diagonal of its box
};

/// Whether a face has a place along a unit vector: as a plane, an axis or a centre.
bool has_place_along(const surfaces::PartSurface& surface, const Vec3& along);

/// Directions of faces: normals and axes, each once.
struct Directions {
  std::vector<Vec3> directions;  ///< unit
  std::vector<int> of_face;      ///< -1: it has none
  std::vector<int> first_face;   ///< of each direction
};

/// Directions that are drawn parallel are one, that of the first face which has it.
Directions find_directions(const std::vector<Face>& faces);

/// The same part with faces that have these directions exactly: what is drawn parallel is parallel.
Part with_common_directions(Part part, const Directions& directions);

}  // namespace epura::definition
