// SPDX-License-Identifier: Apache-2.0
#include "edges/material_along.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace epura::edges {

namespace {

// Whether an edge passes to the right of a point, with one answer for both of its triangles.
bool passes_right_of(Vec2 from, Vec2 to, const Vec2& p) {
  if (from.y > to.y) std::swap(from, to);
  if (!(from.y <= p.y && p.y < to.y)) return false;
  return from.x + (p.y - from.y) / (to.y - from.y) * (to.x - from.x) > p.x;
}

bool is_over(const std::array<Vec3, 3>& corners, const Vec2& p) {
  bool inside = false;
  for (int i = 0; i < 3; ++i)
    if (passes_right_of(Vec2(corners[i]), Vec2(corners[(i + 1) % 3]), p)) inside = !inside;
  return inside;
}

double height_at(const std::array<Vec3, 3>& corners, const Vec2& p) {
  const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Vec2 off = p - Vec2(corners[0]);
  return corners[0].z - (normal.x * off.x + normal.y * off.y) / normal.z;
}

}  // namespace

MaterialAlong::MaterialAlong(const world::World& world, int model, int triangle, const BodyAxis& axis, double radius)
    : axis_(axis) {
  check(radius > 0, "a thread has a radius");
  const Vec3 size = glm::abs(axis.direction);
  const Vec3 aside = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                     : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                          : Vec3(0, 0, 1);
  u_ = glm::normalize(glm::cross(axis.direction, aside));
  v_ = glm::cross(axis.direction, u_);
  const auto number = static_cast<std::size_t>(model);
  const int first = world.first_triangle[number], end = world.first_triangle[number + 1];
  const std::vector<int>& body = world.models[number].mesh->body;
  for (int t = first; t < end; ++t) {
    if (body[static_cast<std::size_t>(t - first)] != body[static_cast<std::size_t>(triangle - first)]) continue;
    std::array<Vec3, 3> corners{};
    double reach = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3 off =
          world.points[static_cast<std::size_t>(world.triangles[static_cast<std::size_t>(t)][i])] - axis.origin;
      corners[i] = {glm::dot(off, u_), glm::dot(off, v_), glm::dot(off, axis.direction)};
      reach = std::max(reach, glm::length(Vec2(corners[i])));
    }
    if (reach >= radius) corners_.push_back(corners);
  }
}

std::optional<std::vector<std::array<double, 2>>> MaterialAlong::at(const Vec3& point) const {
  const Vec2 p(glm::dot(point - axis_.origin, u_), glm::dot(point - axis_.origin, v_));
  std::vector<double> heights;
  for (const std::array<Vec3, 3>& corners : corners_)
    if (is_over(corners, p)) heights.push_back(height_at(corners, p));
  if (heights.size() % 2 != 0) return std::nullopt;
  std::sort(heights.begin(), heights.end());
  std::vector<std::array<double, 2>> spans;
  for (std::size_t i = 0; i < heights.size(); i += 2) spans.push_back({heights[i], heights[i + 1]});
  check(2 * spans.size() == heights.size(), "a line leaves a body as often as it enters it");
  return spans;
}

bool holds(const std::vector<std::array<double, 2>>& spans, double height) {
  return std::any_of(spans.begin(), spans.end(),
                     [height](const auto& span) { return span[0] <= height && height <= span[1]; });
}

}  // namespace epura::edges
