// SPDX-License-Identifier: Apache-2.0
#include "mesh/bodies.hpp"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.hpp"

namespace epura::mesh {

std::vector<int> connected_parts(std::size_t triangle_count, const EdgeTable& table) {
  DisjointSets parts(triangle_count);
  for (const MeshEdge& edge : table.edges) {
    const auto halfedges = table.halfedges_of(edge);
    for (const int halfedge : halfedges.subspan(1)) parts.join(halfedges[0] / 3, halfedge / 3);
  }
  std::vector<int> labels = std::move(parts).roots();
  renumber_labels(labels);
  return labels;
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
