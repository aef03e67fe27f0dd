// SPDX-License-Identifier: Apache-2.0
// The undirected edges of triangles, each with all its half-edges.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace epura::mesh {

/// Half-edge 3t + k leads from corner k of triangle t to the next corner.
struct EdgeTable {
  UnsetVector<MeshEdge> edges;  ///< sorted by their vertices; `first` and `count` refer to `halfedges`
  UnsetVector<int> halfedges;   ///< of each edge, ascending; none for edges that are only wires

  [[nodiscard]] std::span<const int> halfedges_of(const MeshEdge& edge) const {
    return {halfedges.data() + edge.first, static_cast<std::size_t>(edge.count)};
  }
};

/// `corners` has three different vertices per triangle. An edge is a diagonal if it only joins triangles of one
/// polygon.
EdgeTable make_edge_table(std::span<const int> corners, std::span<const int> polygon, int vertex_count);

/// Marks the given edges as wires, and adds those that no triangle has. Pairs of equal vertices are ignored.
void add_wires(EdgeTable& table, std::span<const std::array<int, 2>> wires);

/// Gives a mesh the edges of a table that was made for its triangles.
void set_edges(Mesh& mesh, EdgeTable table);

/// Makes the edges of a mesh from its triangles, and from wires between its vertices.
void make_edges(Mesh& mesh, std::span<const std::array<int, 2>> wires);

/// Returns the vertices of each edge of a mesh that is a wire.
std::vector<std::array<int, 2>> wires_of(const Mesh& mesh);

/// Whether any two triangles have the same three vertices. Such triangles have a common edge.
bool has_equal_triangles(const EdgeTable& table, std::span<const int> corners);

inline int next_in_triangle(int halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }

/// Whether exactly two triangles share the edge and traverse it in opposite directions.
inline bool is_two_sided(const EdgeTable& table, const MeshEdge& edge, std::span<const int> corners) {
  return edge.count == 2 && corners[table.halfedges[edge.first]] != corners[table.halfedges[edge.first + 1]];
}

}  // namespace epura::mesh
