// SPDX-License-Identifier: Apache-2.0
#include "patches.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mesh/bodies.hpp"

namespace epura::bench {

using namespace mesh;

namespace {

/// Classes of numbers that have been joined in pairs.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  void join(int a, int b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }
  /// The class of each number, counted from 0 in order of the first member.
  std::vector<int> labels() {
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) parent_[i] = root(i);
    renumber_labels(parent_);
    return parent_;
  }

 private:
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<int> parent_;
};

int count_of(const std::vector<int>& labels) {
  return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
}

std::vector<Vec3> areas_of(const TriangleMesh& mesh) {
  std::vector<Vec3> areas(mesh.corners.size() / 3);
  for (std::size_t t = 0; t < areas.size(); ++t) {
    const Vec3& a = mesh.points[mesh.corners[3 * t]];
    areas[t] = glm::cross(mesh.points[mesh.corners[3 * t + 1]] - a, mesh.points[mesh.corners[3 * t + 2]] - a);
  }
  return areas;
}

}  // namespace

Patches cut_along_creases(const TriangleMesh& mesh, double crease_angle) {
  const std::size_t count = mesh.corners.size() / 3;
  std::vector<int> polygon(count);
  std::iota(polygon.begin(), polygon.end(), 0);
  Patches cut;
  cut.table = make_edge_table(mesh.corners, polygon, static_cast<int>(mesh.points.size()));
  cut.area = areas_of(mesh);

  const double limit = std::cos(crease_angle * std::numbers::pi / 180);
  Classes patches(count), shells(count), nodes(mesh.corners.size());
  for (const MeshEdge& edge : cut.table.edges) {
    const auto halfedges = cut.table.halfedges_of(edge);
    const bool paired = is_two_sided(cut.table, edge, mesh.corners);
    const int h = halfedges[0], g = paired ? halfedges[1] : h;
    const Vec3 &m = cut.area[h / 3], &n = cut.area[g / 3];
    const bool smooth = paired && glm::dot(m, n) >= limit * glm::length(m) * glm::length(n);
    cut.rim.push_back(!smooth);
    if (paired) shells.join(h / 3, g / 3);
    if (!smooth) continue;
    patches.join(h / 3, g / 3);
    nodes.join(h, next_in_triangle(g));
    nodes.join(next_in_triangle(h), g);
  }
  cut.patch = patches.labels();
  cut.shell = shells.labels();
  cut.node = nodes.labels();
  cut.patch_count = count_of(cut.patch);
  cut.node_count = count_of(cut.node);
  cut.closed.assign(static_cast<std::size_t>(count_of(cut.shell)), 1);
  for (const MeshEdge& edge : cut.table.edges)
    if (!is_two_sided(cut.table, edge, mesh.corners))
      for (const int h : cut.table.halfedges_of(edge)) cut.closed[cut.shell[h / 3]] = 0;
  return cut;
}

}  // namespace epura::bench
