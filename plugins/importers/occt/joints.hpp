// SPDX-License-Identifier: Apache-2.0
// How the faces of a body meet in its edges.
#pragma once

#include <cstdint>
#include <vector>

#include "body_mesh.hpp"

namespace occt {

struct Joint {
  std::vector<std::uint32_t> points;
  bool is_tangent;
  double angle;  ///< degrees between the outward normals: nearly the most along it; NaN: not known
};

/// Edges between two or more faces, in the order in which the faces have them.
std::vector<Joint> joints_of(const BodyMesh& mesh);

}  // namespace occt
