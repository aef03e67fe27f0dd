// SPDX-License-Identifier: Apache-2.0
// What the judges of a drawn view ask of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "accuracy/view_error.hpp"

namespace epura::accuracy {

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
    if (placed.part != nullptr) {
      const surfaces::PartBorder* border = placed.part->border_at(mesh_edge);
      return border == nullptr || border->kind != surfaces::BorderKind::sharp;
    }
    constexpr double sharp = 0.5;  // sine of 30 degrees, the least angle of a crease
    const Vec3 a = normal_of(both[0]), b = normal_of(both[1]);
    return !(glm::length(glm::cross(a, b)) >= sharp * glm::length(a) * glm::length(b));
  }

 protected:
  const ViewToJudge& judged_;
};

}  // namespace epura::accuracy
