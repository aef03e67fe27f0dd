// SPDX-License-Identifier: Apache-2.0
#include "surfaces/free_normals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfaces/least_squares.hpp"
#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

/// Terms of the height over the estimated tangent plane: a x + b y + (c x^2 + 2 d x y + e y^2) / 2.
std::array<double, 5> terms_of(double x, double y) { return {x, y, x * x / 2, x * y, y * y / 2}; }

}  // namespace

FreeNormals::FreeNormals(const Facets& facets, const std::vector<int>& region_of, const std::vector<Region>& regions)
    : facets_(facets), region_of_(region_of) {
  at_vertex_ = Groups<int>(facets.points.size(), [&](const auto& visit) {
    for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f) {
      if (regions[region_of[f]].surface.kind != SurfaceKind::free_form) continue;
      for (const int v : facets.vertices_of(f)) visit(static_cast<std::size_t>(v), f);
    }
  });
}

// Returns the facets of the face at the vertex, with enough rings around them for their vertices to determine a
// paraboloid.
FreeNormals::Patch FreeNormals::patch_around(int facet, int vertex) const {
  Patch patch{{}, {vertex}};
  auto& [facets, vertices] = patch;
  facets.reserve(max_normal_facets);
  vertices.reserve(max_normal_facets);
  std::vector<int> next{vertex}, from;
  const auto is_in = [](const std::vector<int>& all, int i) {
    return std::find(all.begin(), all.end(), i) != all.end();
  };
  for (int ring = 0; ring < 3 && vertices.size() < enough_vertices; ++ring) {
    std::swap(from, next);
    next.clear();
    for (const int v : from)
      for (const int f : at_vertex_[static_cast<std::size_t>(v)]) {
        if (region_of_[f] != region_of_[facet] || is_in(facets, f)) continue;
        if (facets.size() == max_normal_facets) return patch;
        facets.push_back(f);
        for (const int w : facets_.vertices_of(f))
          if (!is_in(vertices, w)) {
            vertices.push_back(w);
            next.push_back(w);
          }
      }
  }
  return patch;
}

std::optional<FreeNormals::Normal> FreeNormals::at(int facet, int vertex) const {
  const Vec3& origin = facets_.points[vertex];
  const Vec3& facing = facets_.facets[facet].normal;
  const auto [facets, vertices] = patch_around(facet, vertex);
  Vec3 guess(0);
  for (const int f : facets) {
    const auto all = facets_.vertices_of(f);
    if (std::find(all.begin(), all.end(), vertex) == all.end()) continue;
    const Facet& there = facets_.facets[f];
    guess += (glm::dot(there.normal, facing) < 0 ? -there.area : there.area) * there.normal;
  }
  if (vertices.size() < min_vertices || !(glm::length(guess) > 0)) return std::nullopt;
  guess = glm::normalize(guess);
  const auto across = square_to(guess);
  double size = 0;
  for (const int v : vertices) size = std::max(size, glm::distance(facets_.points[v], origin));
  std::vector<Vec3> seen;
  seen.reserve(vertices.size());
  for (const int v : vertices) {
    const Vec3 from = (facets_.points[v] - origin) / size;
    seen.emplace_back(glm::dot(from, across[0]), glm::dot(from, across[1]), glm::dot(from, guess));
  }
  NormalEquations<5> equations;
  for (const Vec3& p : seen) equations.add(terms_of(p.x, p.y), p.z);
  const auto found = equations.solve(0);
  if (!found) return std::nullopt;
  double sum = 0;
  for (const Vec3& p : seen) {
    const auto terms = terms_of(p.x, p.y);
    double height = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) height += (*found)[i] * terms[i];
    sum += (p.z - height) * (p.z - height);
  }
  const Vec3 direction = glm::normalize(guess - (*found)[0] * across[0] - (*found)[1] * across[1]);
  if (!finite(direction) || glm::dot(direction, guess) < min_fold_cosine) return std::nullopt;
  return Normal{direction, 4 * std::sqrt(sum / static_cast<double>(vertices.size()))};
}

}  // namespace epura::surfaces
