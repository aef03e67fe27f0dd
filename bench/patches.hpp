// SPDX-License-Identifier: Apache-2.0
// A triangle mesh cut into smooth patches, as B-rep programs want it.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesh/edge_table.hpp"

namespace epura::bench {

struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<int> corners;  ///< three a triangle, all different
};

struct Patches {
  int patch_count, node_count;
  mesh::EdgeTable table;
  std::vector<char> rim;     ///< of each edge: it is a crease or open
  std::vector<Vec3> area;    ///< of each triangle: its normal, as long as twice its area
  std::vector<int> patch;    ///< of each triangle
  std::vector<int> shell;    ///< of each triangle
  std::vector<char> closed;  ///< of each shell
  std::vector<int> node;     ///< of each corner: corners at one vertex are one node unless a crease parts them
};

/// Cuts at open edges, and where triangles fold by more than `crease_angle` degrees.
Patches cut_along_creases(const TriangleMesh& mesh, double crease_angle);

}  // namespace epura::bench
