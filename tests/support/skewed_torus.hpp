// SPDX-License-Identifier: Apache-2.0
// A torus of regular or skewed facets, and its contour.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "shapes.hpp"

namespace epura::test {

/// A torus (20, 8) around z; `skew` moves vertices on it at random, by up to that part of the way to the next.
inline Shape torus(int around, int along, double skew = 0) {
  std::mt19937 random(around);
  const auto moved = [&](int i, int count) {
    return 2 * std::numbers::pi * (i + skew * (std::ldexp(static_cast<double>(random()), -31) - 1)) / count +
           std::numbers::pi / 90;
  };
  Shape shape;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = moved(i, along), t = moved(j, around), away = 20 + 8 * std::cos(t);
      shape.points.push_back({away * std::cos(a), away * std::sin(a), 8 * std::sin(t)});
    }
  const auto number = [&](int i, int j) { return i % along * around + j % around; };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j) {
      const std::array corners{number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)};
      const std::size_t first = random() % 2;
      for (const std::size_t k : {first, first + 2})
        shape.faces.push_back({corners[k % 4], corners[(k + 1) % 4], corners[(k + 2) % 4]});
    }
  return shape;
}

/// Whether the solid of a torus (20, 8) around z lies between a place on its contour and the viewer.
inline bool torus_hides(const Vec3& place, const Vec3& towards) {
  for (double way = 0.5; way < 60; way += 0.05) {
    const Vec3 p = place + way * glm::normalize(towards);
    if (std::hypot(std::hypot(p.x, p.y) - 20, p.z) < 8 - 1e-3) return true;
  }
  return false;
}

/// Places on the visible contour of that torus: it bends away from the viewer on both sides, and nothing is in front.
/// Near cusps it bends little: nothing below `least` counts.
inline std::vector<Vec3> visible_contour_of_torus(const Vec3& towards, double least = 0) {
  constexpr int places = 4000;
  std::vector<Vec3> found;
  for (int i = 0; i < 2 * places; ++i) {
    const double a = 2 * std::numbers::pi * i / places, side = i < places ? 1 : -1;
    const Vec3 out(std::cos(a), std::sin(a), 0), on(-std::sin(a), std::cos(a), 0), axis(0, 0, 1);
    const double t = std::atan2(-side * glm::dot(out, towards), side * towards.z), away = 20 + 8 * std::cos(t);
    const double around_tube = glm::dot(std::cos(t) * axis - std::sin(t) * out, towards);
    const double around_axis = glm::dot(on, towards);
    // The normal curvature along the projector, by the principal ones (Euler).
    const double bend = around_tube * around_tube / 8 + around_axis * around_axis * std::cos(t) / away;
    const Vec3 place = away * out + 8 * std::sin(t) * axis;
    if (bend > least && !torus_hides(place, towards)) found.push_back(place);
  }
  return found;
}

}  // namespace epura::test
