// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.hpp"

#include <algorithm>

namespace epura::mesh {

const MeshEdge* Mesh::edge_between(const std::array<int, 2>& ends) const {
  const auto found = std::ranges::lower_bound(edges, ends, {}, &MeshEdge::vertex);
  return found != edges.end() && found->vertex == ends ? &*found : nullptr;
}

EdgeOrigin Mesh::origin_of(const MeshEdge& edge) const {
  const auto [low, high] = edge.vertex;
  if (cut_vertices.empty() || high < first_cut_vertex) return {edge.vertex, {0, 1}, true};
  const CutVertex& cut = cut_vertices[high - first_cut_vertex];
  if (low == cut.edge[0]) return {cut.edge, {0, cut.t}, true};
  if (low == cut.edge[1]) return {cut.edge, {1, cut.t}, true};
  // Both ends are on one edge of the file that a stepped section cuts more than once.
  if (low >= first_cut_vertex && cut.edge[0] >= 0 && cut_vertices[low - first_cut_vertex].edge == cut.edge)
    return {cut.edge, {cut_vertices[low - first_cut_vertex].t, cut.t}, true};
  return {edge.vertex, {0, 1}, false};
}

}  // namespace epura::mesh
