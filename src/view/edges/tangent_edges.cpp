// SPDX-License-Identifier: Apache-2.0
#include "edges/tangent_edges.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "edges/limits.hpp"

namespace epura::edges {

namespace {

std::array<int, 2> ends_of(const EdgeSurroundings& around, const mesh::MeshEdge& edge) {
  const int first = around.world.first_vertex[around.model];
  return {first + edge.vertex[0], first + edge.vertex[1]};
}

// Negative for an edge that does not have two triangles.
std::vector<double> folds_of(const EdgeSurroundings& around, const mesh::Mesh& mesh) {
  std::vector<double> folds(mesh.edges.size(), -1);
  parallel_for(folds.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const mesh::MeshEdge& edge = mesh.edges[e];
      if (edge.count != 2) continue;
      const auto triangles = mesh.triangles_of(edge);
      folds[e] = edge.diagonal ? 0 : fold_angle(around, ends_of(around, edge), triangles[0], triangles[1]);
      check(folds[e] >= 0 && folds[e] <= 180, "a fold has 0 to 180 degrees");
    }
  });
  return folds;
}

/// Connected coplanar triangles, and the edges around them.
class Facets {
 public:
  Facets(const mesh::Mesh& mesh, const std::vector<double>& folds) : facet_(facets_of(mesh, folds)) {
    for (std::size_t e = 0; e < folds.size(); ++e)
      if (folds[e] < 0 || folds[e] > flat_fold)
        for (const int triangle : mesh.triangles_of(mesh.edges[e]))
          sides_.emplace_back(facet_of(triangle), static_cast<int>(e));
    std::sort(sides_.begin(), sides_.end());
  }

  [[nodiscard]] int facet_of(int triangle) const { return facet_[triangle]; }

  /// Returns pairs of this facet and an edge around it.
  [[nodiscard]] std::span<const std::pair<int, int>> sides(int facet) const {
    const auto [begin, end] = std::equal_range(sides_.begin(), sides_.end(), std::pair(facet, 0),
                                               [](const auto& a, const auto& b) { return a.first < b.first; });
    return {begin, end};
  }

 private:
  static std::vector<int> facets_of(const mesh::Mesh& mesh, const std::vector<double>& folds) {
    DisjointSets facets(mesh.polygon.size());
    for (std::size_t e = 0; e < folds.size(); ++e) {
      if (folds[e] < 0 || folds[e] > flat_fold) continue;
      const auto triangles = mesh.triangles_of(mesh.edges[e]);
      facets.join(triangles[0], triangles[1]);
    }
    std::vector<int> roots = std::move(facets).roots();
    check(roots.size() == mesh.polygon.size(), "every triangle is of a facet");
    return roots;
  }

  std::vector<int> facet_;  // by triangle
  std::vector<std::pair<int, int>> sides_;
};

struct TangencyJudge {
  const EdgeSurroundings& around;
  const mesh::Mesh& mesh;
  const std::vector<double>& folds;
  const Facets& facets;
  double crease_angle;

  [[nodiscard]] bool is_smooth(std::size_t edge) const { return folds[edge] > flat_fold && folds[edge] < crease_angle; }

  // Degrees per length across the edge, on the side of the triangle; the fold is taken to continue evenly if nothing
  // else is known.
  [[nodiscard]] double curvature(std::size_t edge, int triangle) const {
    const std::array<int, 2> ends = ends_of(around, mesh.edges[edge]);
    const Vec3 a = around.point(ends[0]), along = glm::normalize(around.point(ends[1]) - a);
    const auto distance = [&](const Vec3& p) { return glm::length(glm::cross(p - a, along)); };
    const auto sides = facets.sides(facets.facet_of(triangle));
    if (sides.size() > max_sides) return folds[edge] / size_of(sides, a);
    double extent = distance(around.point(around.apex(ends, triangle))), parallel_at = 0, fold = folds[edge];
    for (const auto& [facet, side] : sides) {
      const std::array<int, 2> far = ends_of(around, mesh.edges[std::size_t(side)]);
      const Vec3 from = around.point(far[0]), to = around.point(far[1]);
      const double nearer = std::min(distance(from), distance(to));
      extent = std::max({extent, distance(from), distance(to)});
      if (std::abs(glm::dot(to - from, along)) < nearly_parallel * glm::length(to - from) || nearer <= parallel_at)
        continue;
      parallel_at = nearer;
      fold = is_smooth(std::size_t(side)) ? (folds[edge] + folds[std::size_t(side)]) / 2 : folds[edge];
    }
    return fold / extent;
  }

  [[nodiscard]] double size_of(std::span<const std::pair<int, int>> sides, const Vec3& from) const {
    double size = 0;
    for (const auto& [facet, side] : sides)
      for (const int v : ends_of(around, mesh.edges[std::size_t(side)]))
        size = std::max(size, glm::length(around.point(v) - from));
    return size / 2;
  }

  [[nodiscard]] bool is_tangent(std::size_t edge) const {
    if (!is_smooth(edge)) return false;
    const auto triangles = mesh.triangles_of(mesh.edges[edge]);
    const double one = curvature(edge, triangles[0]), two = curvature(edge, triangles[1]);
    return std::max(one, two) > curvature_ratio * std::min(one, two);
  }
};

}  // namespace

std::vector<char> tangent_edges(const EdgeSurroundings& around, double crease_angle) {
  const mesh::Mesh& mesh = around.mesh();
  const std::vector<double> folds = folds_of(around, mesh);
  const Facets facets(mesh, folds);
  const TangencyJudge judge{around, mesh, folds, facets, crease_angle};
  std::vector<char> tangent(mesh.edges.size());
  parallel_for(tangent.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) tangent[e] = judge.is_tangent(e) ? 1 : 0;
  });
  return tangent;
}

}  // namespace epura::edges
