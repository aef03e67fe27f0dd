// SPDX-License-Identifier: Apache-2.0
#include "surfaces/pairs_by_body.hpp"

#include <algorithm>
#include <span>

namespace epura::surfaces {

std::vector<TrianglePair> pairs_by_body(const mesh::Mesh& mesh, const mesh::MeshEdge& edge) {
  const std::span<const int> triangles = mesh.triangles_of(edge);
  if (triangles.size() == 2) return {{triangles[0], triangles[1]}};
  if (triangles.size() % 2 != 0) return {};
  std::vector<int> sorted(triangles.begin(), triangles.end());
  const auto body = [&](std::size_t i) { return mesh.body[static_cast<std::size_t>(sorted[i])]; };
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    return mesh.body[static_cast<std::size_t>(a)] < mesh.body[static_cast<std::size_t>(b)];
  });
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < sorted.size(); i += 2) {
    if (body(i) != body(i + 1) || (i > 0 && body(i - 1) == body(i))) return {};
    pairs.push_back({sorted[i], sorted[i + 1]});
  }
  return pairs;
}

}  // namespace epura::surfaces
