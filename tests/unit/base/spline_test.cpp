// SPDX-License-Identifier: Apache-2.0
#include "base/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test::spline_test {
namespace {

// Two quarters of a unit circle, whose inner knot counts twice.
Spline half_circle() {
  const double s = std::sqrt(0.5);
  return {2, {{1, 0, 0, 1}, {s, s, 0, s}, {0, 1, 0, 1}, {-s, s, 0, s}, {-1, 0, 0, 1}}, {0, 0, 0, 1, 1, 3, 3, 3}};
}

TEST(Splines, OfAHalfCircleAreOnIt) {
  const Spline spline = half_circle();
  for (int i = 0; i <= 30; ++i) {
    const Vec4 p = point_of(spline, 0.1 * i);
    EXPECT_NEAR(std::hypot(p.x, p.y) / p.w, 1, 1e-14) << i;
    EXPECT_GE(p.y, -1e-14);
  }
  const Vec4 first = point_of(spline, 0), middle = point_of(spline, 1), last = point_of(spline, 3);
  EXPECT_NEAR(first.x / first.w, 1, 1e-14);
  EXPECT_NEAR(middle.y / middle.w, 1, 1e-14);
  EXPECT_NEAR(last.x / last.w, -1, 1e-14);
}

// Uniform knots count once: the quadratic spline passes the middles of the sides of its poles at knots.
TEST(Splines, NeedNoRepeatedKnots) {
  const Spline spline{2, {{0, 0, 0, 1}, {2, 0, 0, 1}, {2, 2, 0, 1}, {4, 2, 0, 1}}, {0, 1, 2, 3, 4, 5, 6}};
  for (int knot = 2; knot <= 4; ++knot) {
    const auto i = static_cast<std::size_t>(knot - 2);
    EXPECT_LT(glm::distance(point_of(spline, knot), (spline.poles[i] + spline.poles[i + 1]) / 2.0), 1e-14);
  }
}

TEST(Splines, FindTheNearestPointInEitherDirection) {
  const Spline spline = half_circle();
  for (const double wanted : {1.0, 1.25, 2.0, 2.5}) {
    const Vec4 at = point_of(spline, wanted);
    const auto distance = [&](const Vec4& p) { return glm::distance(Vec3(p) / p.w, Vec3(at) / at.w); };
    EXPECT_NEAR(nearest_parameter(spline, 1, 2.5, distance), wanted, 1e-9);
    EXPECT_NEAR(nearest_parameter(spline, 2.5, 1, distance), wanted, 1e-9);
  }
}

}  // namespace
}  // namespace epura::test::spline_test
