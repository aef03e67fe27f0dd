// SPDX-License-Identifier: Apache-2.0
// Joins creases and boundaries of a mesh end to end.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace epura::mesh {

/// The positions of a mesh's vertices and the corners of its triangles: either those of its file, or those in a world.
struct PlacedMesh {
  const Mesh& mesh;
  std::span<const Vec3> points;                   ///< vertex v at first_vertex + v
  std::span<const std::array<int, 3>> triangles;  ///< corners numbered like points
  int first_vertex = 0;

  [[nodiscard]] const Vec3& point(int vertex) const { return points[first_vertex + vertex]; }
};

struct FeatureLine {
  std::vector<int> vertices;  ///< of the file, at least two; the first one of a closed line is not repeated
  bool closed;
};

/// Returns lines along edges with one triangle, with three or more, and with two that are folded by `crease_angle`
/// degrees or more. Each edge is in one line. Where several lines meet in a vertex, the straightest continuations are
/// joined; lines end where they would turn by more than `max_turn` radians.
std::vector<FeatureLine> find_feature_lines(const PlacedMesh& mesh, double crease_angle, double max_turn);

}  // namespace epura::mesh
