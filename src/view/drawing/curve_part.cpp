// SPDX-License-Identifier: Apache-2.0
#include "drawing/curve_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"

namespace epura::drawing {

namespace {

const Vec2& at(const std::vector<Vec2>& points, int index) {
  return points[static_cast<std::size_t>(index) % points.size()];
}

double angle_of(const CurvePart& curve, const Vec2& p) {
  const Vec2 d = p - curve.centre;
  return portable_atan2(glm::dot(d, curve.v) / glm::dot(curve.v, curve.v),
                        glm::dot(d, curve.u) / glm::dot(curve.u, curve.u));
}

}  // namespace

Vec2 position_on_curve(const CurvePart& curve, double angle) {
  return curve.centre + portable_cos(angle) * curve.u + portable_sin(angle) * curve.v;
}

std::vector<Vec2> outermost_places(const CurvePart& curve) {
  const auto [low, high] = std::minmax(curve.from, curve.to);
  std::vector<Vec2> places;
  for (const int axis : {0, 1}) {
    const double first = portable_atan2(curve.v[axis], curve.u[axis]);
    const double half_turns = std::ceil((low - first) / std::numbers::pi);
    for (double angle = first + half_turns * std::numbers::pi; angle <= high; angle += std::numbers::pi)
      places.push_back(position_on_curve(curve, angle));
  }
  return places;
}

std::vector<double> corner_angles(const CurvePart& curve, const std::vector<Vec2>& points) {
  std::vector<double> angles{curve.from};
  for (int i = curve.first + 1; i < curve.last; ++i) {
    const double step = angle_of(curve, at(points, i)) - angles.back();
    angles.push_back(angles.back() + std::remainder(step, 2 * std::numbers::pi));
  }
  angles.push_back(curve.to);
  check(angles.size() == static_cast<std::size_t>(curve.last - curve.first + 1),
        "every corner of a curve has an angle");
  return angles;
}

double length_of_curve(const CurvePart& curve, double from, double to) {
  // Gauss-Legendre quadrature with three nodes for each piece.
  constexpr std::array<double, 3> places{-0.7745966692414834, 0, 0.7745966692414834};
  constexpr std::array<double, 3> weights{5.0 / 9, 8.0 / 9, 5.0 / 9};
  const double piece = 5 * std::numbers::pi / 180;
  const int pieces = static_cast<int>(std::abs(to - from) / piece) + 1;
  const double half = (to - from) / (2 * pieces);
  double length = 0;
  for (int i = 0; i < pieces; ++i)
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double angle = from + (2 * i + 1 + places[k]) * half;
      length += weights[k] * glm::length(portable_cos(angle) * curve.v - portable_sin(angle) * curve.u);
    }
  return length * std::abs(half);
}

std::vector<CurvePart> curves_between(std::span<const CurvePart> curves, const std::vector<Vec2>& points, int first,
                                      int last) {
  const int count = static_cast<int>(points.size());
  std::vector<CurvePart> parts;
  for (const int shift : {0, count}) {
    for (const CurvePart& curve : curves) {
      const int low = std::max(curve.first + shift, first), high = std::min(curve.last + shift, last);
      if (low >= high) continue;
      const std::vector<double> angles = corner_angles(curve, points);
      CurvePart part = curve;
      part.from = angles[static_cast<std::size_t>(low - shift - curve.first)];
      part.to = angles[static_cast<std::size_t>(high - shift - curve.first)];
      part.first = low - first;
      part.last = high - first;
      check(part.first >= 0 && part.last <= last - first, "a part of a curve lies between the points wanted");
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<double> distances_along(const std::vector<Vec2>& points, bool closed, std::span<const CurvePart> curves) {
  const int count = static_cast<int>(points.size());
  std::vector<double> distances{0};
  distances.reserve(points.size() + 1);
  const auto add = [&](double length) { distances.push_back(distances.back() + length); };
  const auto lines_to = [&](int last) {
    for (int i = static_cast<int>(distances.size()); i <= last; ++i)
      add(glm::distance(at(points, i - 1), at(points, i)));
  };
  for (const CurvePart& curve : curves) {
    lines_to(curve.first);
    const std::vector<double> angles = corner_angles(curve, points);
    for (std::size_t i = 1; i < angles.size(); ++i) add(length_of_curve(curve, angles[i - 1], angles[i]));
  }
  lines_to(closed ? count : count - 1);
  check(distances.size() == points.size() + (closed ? 1 : 0) || points.empty(), "every point has a distance");
  check(distances.back() >= 0, "a length is not negative");
  return distances;
}

}  // namespace epura::drawing
