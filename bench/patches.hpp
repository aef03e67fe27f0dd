// SPDX-License-Identifier: Apache-2.0
// A triangle mesh divided into smooth patches, as B-rep programs need it.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesh/edge_table.hpp"

namespace epura::bench {

struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<int> corners;  ///< three per triangle, all different
};

struct Patches {
  int patch_count, node_count;
  mesh::EdgeTable table;
  std::vector<char> rim;     ///< by edge: whether it is a crease or open
  std::vector<Vec3> area;    ///< by triangle: its normal, with a length of twice its area
  std::vector<int> patch;    ///< by triangle
  std::vector<int> shell;    ///< by triangle
  std::vector<char> closed;  ///< by shell
  std::vector<int> node;     ///< by corner: corners at one vertex are one node unless separated by a crease
};

/// Cuts along open edges, and edges with a fold of more than `crease_angle` degrees.
Patches cut_along_creases(const TriangleMesh& mesh, double crease_angle);

}  // namespace epura::bench
