// SPDX-License-Identifier: Apache-2.0
// The undirected edges of triangles, each with all half-edges along it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace epura::mesh {

/// Half-edge 3t + k runs along triangle t from its corner k to the next one.
struct EdgeTable {
  UnsetVector<MeshEdge> edges;  ///< sorted by their vertices; `first` and `count` refer to `halfedges`
  UnsetVector<int> halfedges;   ///< of each edge, ascending; none where it is a piece of a wire only

  [[nodiscard]] std::span<const int> halfedges_of(const MeshEdge& edge) const {
    return {halfedges.data() + edge.first, static_cast<std::size_t>(edge.count)};
  }
};

/// `corners` has three vertices a triangle, all different; an edge is a diagonal where it joins triangles of one
/// polygon only.
EdgeTable make_edge_table(std::span<const int> corners, std::span<const int> polygon, int vertex_count);

/// Marks the edges between two different vertices each as wires, and adds those that no triangle has.
void add_wires(EdgeTable& table, std::span<const std::array<int, 2>> wires);

/// Whether two triangles have the same three vertices. Such have an edge in common.
bool has_equal_triangles(const EdgeTable& table, std::span<const int> corners);

inline int next_in_triangle(int halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }

/// Whether exactly two triangles share the edge and run along it in opposite directions.
inline bool is_two_sided(const EdgeTable& table, const MeshEdge& edge, std::span<const int> corners) {
  return edge.count == 2 && corners[table.halfedges[edge.first]] != corners[table.halfedges[edge.first + 1]];
}

}  // namespace epura::mesh
