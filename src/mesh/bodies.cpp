// SPDX-License-Identifier: Apache-2.0
#include "mesh/bodies.hpp"

#include <algorithm>
#include <numeric>

namespace epura::mesh {

namespace {

int root_of(std::vector<int>& parent, int triangle) {
  while (parent[triangle] != triangle) triangle = parent[triangle] = parent[parent[triangle]];
  return triangle;
}

}  // namespace

std::vector<int> connected_parts(std::size_t triangle_count, const EdgeTable& table) {
  std::vector<int> parent(triangle_count);
  std::iota(parent.begin(), parent.end(), 0);
  for (const MeshEdge& edge : table.edges) {
    const auto halfedges = table.halfedges_of(edge);
    for (const int halfedge : halfedges.subspan(1)) {
      const auto [low, high] = std::minmax({root_of(parent, halfedges[0] / 3), root_of(parent, halfedge / 3)});
      parent[high] = low;
    }
  }
  for (int t = 0; t < static_cast<int>(triangle_count); ++t) parent[t] = root_of(parent, t);
  renumber_labels(parent);
  return parent;
}

std::vector<int> renumber_labels(std::vector<int>& labels) {
  std::vector<int> found;
  if (labels.empty()) return found;
  std::vector<int> number(static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end())) + 1, -1);
  for (int& label : labels) {
    if (number[label] < 0) {
      number[label] = static_cast<int>(found.size());
      found.push_back(label);
    }
    label = number[label];
  }
  return found;
}

}  // namespace epura::mesh
