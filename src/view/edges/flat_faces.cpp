// SPDX-License-Identifier: Apache-2.0
#include "edges/flat_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "edges/limits.hpp"

namespace epura::edges {

namespace {

// Smaller faces have few pairs of triangles to skip.
constexpr std::size_t min_of_face = 256;

class FlatFaces {
 public:
  FlatFaces(const world::World& world, std::span<const Vec3> points, double contact, const std::vector<int>& triangles)
      : world_(world), points_(points), contact_(contact), triangles_(triangles), regions_(triangles.size()) {}

  std::vector<int> find() {
    auto begin = triangles_.begin();
    for (std::size_t model = 0; model < world_.models.size(); ++model) {
      const int behind = world_.first_triangle[model] + static_cast<int>(world_.models[model].mesh->polygon.size());
      const auto end = std::lower_bound(begin, triangles_.end(), behind);
      if (static_cast<std::size_t>(end - begin) >= min_of_face)
        join_neighbours(model, begin - triangles_.begin(), end - begin);
      begin = end;
    }
    return numbered();
  }

 private:
  // Normal vector; its length is twice the area.
  [[nodiscard]] Vec3 area_of(int triangle) const {
    const auto& [a, b, c] = world_.triangles[triangle];
    return glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
  }

  // The plane is that of the larger triangle, whose corners are rounded as well.
  [[nodiscard]] bool lie_in_one_plane(int a, int b) const {
    Vec3 normal = area_of(a);
    const Vec3 other = area_of(b);
    if (glm::dot(normal, normal) < glm::dot(other, other)) {
      std::swap(a, b);
      normal = other;
    }
    const Vec3& origin = points_[world_.triangles[a][0]];
    const double max = join_contacts * contact_ * glm::length(normal);
    const auto& corners = world_.triangles[b];
    return std::all_of(corners.begin(), corners.end(),
                       [&](int v) { return std::abs(glm::dot(normal, points_[v] - origin)) <= max; });
  }

  // Considers `count` triangles of the model, starting at index `first` of the list.
  void join_neighbours(std::size_t model, std::ptrdiff_t first, std::ptrdiff_t count) {
    const mesh::Mesh& mesh = *world_.models[model].mesh;
    std::vector<int> place(mesh.polygon.size(), -1);
    for (std::ptrdiff_t i = first; i < first + count; ++i)
      place[triangles_[i] - world_.first_triangle[model]] = static_cast<int>(i);
    for (const mesh::MeshEdge& edge : mesh.edges) {
      const auto both = mesh.triangles_of(edge);
      if (both.size() != 2 || place[both[0]] < 0 || place[both[1]] < 0) continue;
      const int a = place[both[0]], b = place[both[1]];
      if (lie_in_one_plane(triangles_[a], triangles_[b])) regions_.join(a, b);
    }
  }

  // Uses the plane perpendicular to the sum of the area vectors: that of a single triangle is uncertain, particularly
  // that of a needle.
  [[nodiscard]] bool is_flat(std::span<const int> region) const {
    Vec3 normal(0);
    for (const int i : region) {
      const Vec3 area = area_of(triangles_[i]);
      normal += glm::dot(area, normal) < 0 ? -area : area;
    }
    double min = HUGE_VAL, max = -HUGE_VAL;
    for (const int i : region)
      for (const int v : world_.triangles[triangles_[i]]) {
        const double height = glm::dot(normal, points_[v]);
        min = std::min(min, height);
        max = std::max(max, height);
      }
    return max - min <= 2 * contact_ * glm::length(normal);
  }

  std::vector<int> numbered() {
    std::vector<std::pair<int, int>> by_region;  // root and index in the list
    for (int i = 0; i < static_cast<int>(triangles_.size()); ++i)
      if (const int root = regions_.root(i); root != i) by_region.emplace_back(root, i);
    check(by_region.size() < triangles_.size(), "the roots of regions are not listed with them");
    std::sort(by_region.begin(), by_region.end());
    std::vector<int> faces;
    int count = 0;
    for (auto begin = by_region.begin(); begin != by_region.end();) {
      std::vector<int> region{begin->first};
      for (const int root = begin->first; begin != by_region.end() && begin->first == root; ++begin)
        region.push_back(begin->second);
      if (region.size() < min_of_face || !is_flat(region)) continue;
      faces.resize(triangles_.size(), -1);
      for (const int i : region) faces[i] = count;
      ++count;
    }
    return faces;
  }

  const world::World& world_;
  std::span<const Vec3> points_;
  double contact_;
  const std::vector<int>& triangles_;
  DisjointSets regions_;  // of indices in the list
};

}  // namespace

std::vector<int> flat_faces(const world::World& world, std::span<const Vec3> points, double contact,
                            const std::vector<int>& triangles) {
  if (triangles.size() < min_of_face) return {};
  std::vector<int> faces = FlatFaces(world, points, contact, triangles).find();
  check(faces.empty() || faces.size() == triangles.size(), "every triangle is of a flat face or not");
  return faces;
}

}  // namespace epura::edges
