// SPDX-License-Identifier: Apache-2.0
#include "verify/verify_input.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/drawing.hpp"

namespace epura::verify {

namespace {

Vec4 row(const Mat4& m, int i) { return glm::transpose(m)[i]; }

// Whether a part of an edge lies on it. A cut moves its end onto the surface of the part (cut/true_outline.hpp).
bool is_between(const std::array<Vec3, 2>& part, const std::array<double, 2>& t, const Vec3& a, const Vec3& b) {
  const double rounding = 0x1p-44 * std::max(glm::length(a), glm::length(b));
  const auto lies_at = [&](std::size_t i) { return glm::distance(part[i], a + t[i] * (b - a)) <= rounding; };
  return lies_at(0) && lies_at(1);
}

// The line of a part of an edge, with the same parameters.
std::array<Vec3, 2> extended(const std::array<Vec3, 2>& part, const std::array<double, 2>& t) {
  const auto at = [&](double parameter) { return part[0] + (parameter - t[0]) / (t[1] - t[0]) * (part[1] - part[0]); };
  return {at(0), at(1)};
}

}  // namespace

std::array<Vec3, 2> VerifyInput::ends_of(const edges::FeatureEdge& edge) const {
  if (edge.crossing >= 0) return drawn.crossings[edge.crossing].ends;
  const mesh::Mesh& mesh = *world.models[edge.model].mesh;
  const mesh::MeshEdge& drawn_edge = mesh.edges[edge.mesh_edge];
  const mesh::EdgeOrigin origin = mesh.origin_of(drawn_edge);
  const auto point = [&](int v) { return world.points[static_cast<std::size_t>(world.first_vertex[edge.model] + v)]; };
  const Vec3 a = point(origin.vertex[0]), b = point(origin.vertex[1]);
  const std::array<Vec3, 2> remains{point(drawn_edge.vertex[0]), point(drawn_edge.vertex[1])};
  return is_between(remains, origin.t, a, b) ? std::array{a, b} : extended(remains, origin.t);
}

std::array<int, 2> VerifyInput::vertices_of(int model, int mesh_edge) const {
  const int first = world.first_vertex[model];
  const auto& [a, b] = world.models[model].mesh->edges[mesh_edge].vertex;
  return {first + a, first + b};
}

bool VerifyInput::contains(const edges::FeatureEdge& edge, int triangle) const {
  if (edge.crossing >= 0) {
    const auto& [first, second] = drawn.crossings[edge.crossing].triangles;
    return triangle == first || triangle == second;
  }
  const auto& corners = world.triangles[triangle];
  return std::ranges::all_of(vertices_of(edge.model, edge.mesh_edge),
                             [&](int v) { return std::ranges::find(corners, v) != corners.end(); });
}

bool VerifyInput::joined(const edges::FeatureEdge& edge, int triangle) const {
  if (edge.crossing >= 0) return false;
  const auto& corners = world.triangles[triangle];
  return std::ranges::any_of(vertices_of(edge.model, edge.mesh_edge),
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
