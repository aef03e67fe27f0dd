// SPDX-License-Identifier: Apache-2.0
#include "verify/verify_input.hpp"

#include <algorithm>
#include <cmath>

namespace epura::verify {

namespace {

Vec4 row(const Mat4& m, int i) { return glm::transpose(m)[i]; }

std::array<int, 2> vertices_of(const VerifyInput& input, const edges::FeatureEdge& edge) {
  const int first = input.world.first_vertex[edge.model];
  const auto& vertex = input.world.models[edge.model].mesh->edges[edge.mesh_edge].vertex;
  return {first + vertex[0], first + vertex[1]};
}

}  // namespace

std::array<Vec3, 2> VerifyInput::ends_of(const edges::FeatureEdge& edge) const {
  if (edge.crossing >= 0) return drawn.crossings[edge.crossing].ends;
  const mesh::Mesh& mesh = *world.models[edge.model].mesh;
  const auto [a, b] = mesh.origin_of(mesh.edges[edge.mesh_edge]).vertex;
  const int first = world.first_vertex[edge.model];
  return {world.points[first + a], world.points[first + b]};
}

bool VerifyInput::contains(const edges::FeatureEdge& edge, int triangle) const {
  if (edge.crossing >= 0) {
    const auto& [first, second] = drawn.crossings[edge.crossing].triangles;
    return triangle == first || triangle == second;
  }
  const auto& corners = world.triangles[triangle];
  return std::ranges::all_of(vertices_of(*this, edge),
                             [&](int v) { return std::ranges::find(corners, v) != corners.end(); });
}

bool VerifyInput::joined(const edges::FeatureEdge& edge, int triangle) const {
  if (edge.crossing >= 0) return false;
  const auto& corners = world.triangles[triangle];
  return std::ranges::any_of(vertices_of(*this, edge),
                             [&](int v) { return std::ranges::find(corners, v) != corners.end(); });
}

Viewing viewing_of(const VerifyInput& input) {
  const projection::Projection& p = input.projection;
  const double viewer = p.central ? glm::dot(p.n, p.projector - p.point) : 0;
  double front = p.front, back = p.back;
  if (input.limits.near) front = std::min(front, viewer - *input.limits.near);
  if (input.limits.far) back = std::max(back, viewer - *input.limits.far);

  const Mat4& m = input.drawing.world_to_page;
  const Vec4 middle(input.world.box.centre(), 1);
  const Vec4 depth = row(m, 2), w = row(m, 3);
  const double depth_along = glm::dot(Vec3(depth), p.n), w_along = glm::dot(Vec3(w), p.n);
  Viewing viewing{p, {}, {}, glm::dot(Vec3(row(m, 0)), p.u), 0, 0};
  // depth / w between two points at distances s along n: (z' w - z w') s / (w1 w2).
  viewing.depth = depth_along * glm::dot(w, middle) - w_along * glm::dot(depth, middle);
  viewing.w = p.central ? -w_along : w.w;
  if (std::isfinite(front)) viewing.front = front;
  if (std::isfinite(back)) viewing.back = back;
  return viewing;
}

}  // namespace epura::verify
