// SPDX-License-Identifier: Apache-2.0
#include "study/methods/point_rule.hpp"

#include <algorithm>

namespace epura::study {

namespace {

// Points closer to a side than this fraction of the drawing lie on it: there are no gaps between neighbours.
constexpr double on_side = 0x1p-44;

}  // namespace

Vec2 PointRule::position(double s) const {
  const Vec2 p = view_.vertices[edge_.p].at();
  return p + s * (view_.vertices[edge_.q].at() - p);
}

double PointRule::depth(double s) const {
  const double p = view_.vertices[edge_.p].depth;
  return p + s * (view_.vertices[edge_.q].depth - p);
}

bool PointRule::hides(const view::ViewTriangle& triangle, double s) const {
  const Vec2 point = position(s);
  bool left = true, right = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 a = view_.vertices[triangle.vertex[i]].at();
    const Vec2 side = view_.vertices[triangle.vertex[(i + 1) % 3]].at() - a;
    const double turn = cross(side, point - a);
    const double slack = on_side * view_.extent * (std::abs(side.x) + std::abs(side.y));
    left = left && turn >= -slack;
    right = right && turn <= slack;
  }
  return (left || right) && lies_before(triangle, s);
}

bool PointRule::lies_before(const view::ViewTriangle& triangle, double s) const {
  const std::optional<Vec2> slope = visibility::slope_of(view_, triangle);
  if (!slope) return false;
  const auto& own = triangle.vertex;
  const bool holds_p = std::find(own.begin(), own.end(), edge_.p) != own.end();
  const bool holds_q = std::find(own.begin(), own.end(), edge_.q) != own.end();
  const double steepness = 1 + glm::length(*slope);
  if (holds_p || holds_q) {
    // From a common corner, the difference grows from zero, and the tolerance with it: the other end decides. Near the
    // corner, the difference of two positions would be mostly rounding.
    const view::PageVertex& corner = view_.vertices[holds_p ? edge_.p : edge_.q];
    const view::PageVertex& end = view_.vertices[holds_p ? edge_.q : edge_.p];
    const double ahead = visibility::rise_along(view_, triangle, end.at() - corner.at()) + corner.depth - end.depth;
    return ahead > view_.contact.joined * steepness;
  }
  const view::PageVertex& corner = view_.vertices[own[0]];
  const double ahead = glm::dot(*slope, position(s) - corner.at()) + corner.depth - depth(s);
  return ahead > view_.contact.touching * steepness;
}

}  // namespace epura::study
