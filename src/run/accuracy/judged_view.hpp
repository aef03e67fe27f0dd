// SPDX-License-Identifier: Apache-2.0
// What the judges of a drawn view ask of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "accuracy/view_error.hpp"

namespace epura::accuracy {

/// The edge of the whole mesh, to which recognised faces belong, on which that of a model lies, which may be cut; null
/// if it runs across a facet.
inline const mesh::MeshEdge* edge_of_part(const world::Placed& placed, std::ptrdiff_t mesh_edge) {
  const mesh::Mesh& whole = placed.mesh->whole();
  const mesh::MeshEdge* edge = &placed.mesh->edges[static_cast<std::size_t>(mesh_edge)];
  return &whole == placed.mesh.get() ? edge : whole.edge_between(placed.mesh->origin_of(*edge).vertex);
}

/// Whether recognised faces on both sides of such an edge are of one surface, or tangent.
inline bool is_inside_part(const world::Placed& placed, std::ptrdiff_t mesh_edge) {
  const mesh::MeshEdge* edge = edge_of_part(placed, mesh_edge);
  if (edge == nullptr) return false;
  const surfaces::PartBorder* border = placed.part->border_at(edge - placed.mesh->whole().edges.data());
  return border == nullptr || border->kind != surfaces::BorderKind::sharp;
}

class JudgedView {
 public:
  /// The view must outlive it.
  explicit JudgedView(const ViewToJudge& judged) : judged_(judged) {}

  /// On paper, mm, from the middle of the view.
  [[nodiscard]] Vec2 place_of(int vertex) const {
    const view::PageVertex& at = judged_.view.vertices[vertex];
    return judged_.paper.scale * Vec2(at.x, at.y);
  }

  /// The longest image on paper of a unit length at a vertex of the view, mm: the larger singular value of the map's
  /// derivative.
  [[nodiscard]] double stretch_at(int vertex) const {
    const view::ViewMap& map = judged_.view.map;
    const view::PageVertex& at = judged_.view.vertices[vertex];
    const Vec2 page = Vec2(at.x, at.y) + judged_.view.middle;
    const Vec3 a = (map.u - page.x * map.w) / at.w, b = (map.v - page.y * map.w) / at.w;
    const double aa = glm::dot(a, a), bb = glm::dot(b, b), ab = glm::dot(a, b), half = (aa - bb) / 2;
    return std::sqrt((aa + bb) / 2 + std::sqrt(half * half + ab * ab)) * map.normalisation * judged_.paper.scale;
  }

  [[nodiscard]] double longest_side(int triangle) const {
    const auto& [a, b, c] = judged_.world.triangles[triangle];
    const auto& points = judged_.world.points;
    return std::max({glm::distance(points[a], points[b]), glm::distance(points[b], points[c]),
                     glm::distance(points[c], points[a])});
  }

  // Twice its area long.
  [[nodiscard]] Vec3 normal_of(int triangle) const {
    const auto& [a, b, c] = judged_.world.triangles[triangle];
    const auto& points = judged_.world.points;
    return glm::cross(points[b] - points[a], points[c] - points[a]);
  }

  // Whether facets on both sides are of one surface.
  [[nodiscard]] bool is_inside(const world::Placed& placed, std::ptrdiff_t mesh_edge,
                               const std::array<int, 2>& both) const {
    if (placed.part != nullptr) return is_inside_part(placed, mesh_edge);
    constexpr double sharp = 0.5;  // sine of 30 degrees, the least angle of a crease
    const Vec3 a = normal_of(both[0]), b = normal_of(both[1]);
    return !(glm::length(glm::cross(a, b)) >= sharp * glm::length(a) * glm::length(b));
  }

  // By vertex: whether a surface ends there, and contours with it.
  [[nodiscard]] std::vector<char> vertices_of_rims() const {
    std::vector<char> rims(judged_.view.vertices.size(), 0);
    for (std::size_t m = 0; m < judged_.world.models.size(); ++m) {
      const world::Placed& placed = judged_.world.models[m];
      const int first = judged_.world.first_triangle[m], before = judged_.world.first_vertex[m];
      for (std::size_t e = 0; e < placed.mesh->edges.size(); ++e) {
        const std::span<const int> beside = placed.mesh->triangles_of(placed.mesh->edges[e]);
        if (beside.size() == 2 && (placed.part == nullptr || is_inside(placed, static_cast<std::ptrdiff_t>(e),
                                                                       {first + beside[0], first + beside[1]})))
          continue;
        for (const int vertex : placed.mesh->edges[e].vertex) rims[static_cast<std::size_t>(before + vertex)] = 1;
      }
    }
    return rims;
  }

 protected:
  const ViewToJudge& judged_;
};

}  // namespace epura::accuracy
