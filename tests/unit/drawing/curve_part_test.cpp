// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: dashes on curves, and which arcs a part of a line keeps.
#include "drawing/curve_part.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace epura::test::curve_part_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(CurvePart, LengthsAreThoseOfTheCurve) {
  const drawing::CurvePart circle{0, 1, {3, 4}, {7, 0}, {0, 7}, 0, 2};
  EXPECT_NEAR(drawing::length_of_curve(circle, 0.25, 1.75), 7 * 1.5, 1e-9);
  EXPECT_NEAR(drawing::length_of_curve(circle, 1.75, 0.25), 7 * 1.5, 1e-9);
  // 2 a E(e): half axes 2 and 1.
  const drawing::CurvePart oval{0, 1, {0, 0}, {2, 0}, {0, 1}, 0, 2 * pi};
  EXPECT_NEAR(drawing::length_of_curve(oval, 0, 2 * pi), 9.688448220547676, 1e-9);
}

// A line of 10, three quarters of a circle of radius 5 in steps of 15 degrees, a line of 10.
struct Hook {
  std::vector<Vec2> points{{5, -10}};
  drawing::CurvePart arc{1, 19, {0, 0}, {5, 0}, {0, 5}, 0, 1.5 * pi};

  Hook() {
    for (int i = 0; i <= 18; ++i) points.push_back(drawing::position_on_curve(arc, pi / 12 * i));
    points.emplace_back(10, -5);
  }
};

TEST(CurvePart, CornersHaveTheirAngles) {
  const Hook hook;
  const std::vector<double> angles = drawing::corner_angles(hook.arc, hook.points);
  ASSERT_EQ(angles.size(), 19U);
  for (int i = 0; i <= 18; ++i) EXPECT_NEAR(angles[std::size_t(i)], pi / 12 * i, 1e-12);
}

TEST(CurvePart, DistancesAreMeasuredAlongCurves) {
  const Hook hook;
  const std::vector<drawing::CurvePart> curves{hook.arc};
  const auto open = drawing::distances_along(hook.points, false, curves);
  ASSERT_EQ(open.size(), 21U);
  EXPECT_NEAR(open[1], 10, 1e-12);
  EXPECT_NEAR(open[7], 10 + 5 * pi / 2, 1e-9);
  EXPECT_NEAR(open[20], 20 + 5 * 1.5 * pi, 1e-9);
  const auto closed = drawing::distances_along(hook.points, true, curves);
  ASSERT_EQ(closed.size(), 22U);
  EXPECT_NEAR(closed[21], open[20] + std::hypot(5, 5), 1e-9);
  EXPECT_LT(drawing::distances_along(hook.points, false, {})[20], open[20]);
}

TEST(CurvePart, PartsKeepTheirPlaces) {
  const Hook hook;
  const std::vector<drawing::CurvePart> curves{hook.arc};
  const auto middle = drawing::curves_between(curves, hook.points, 4, 12);
  ASSERT_EQ(middle.size(), 1U);
  EXPECT_EQ(middle[0].first, 0);
  EXPECT_EQ(middle[0].last, 8);
  EXPECT_NEAR(middle[0].from, pi / 4, 1e-12);
  EXPECT_NEAR(middle[0].to, 11 * pi / 12, 1e-12);
  // Round the end of the closed line: the end of the arc, two lines, and its beginning.
  const auto round = drawing::curves_between(curves, hook.points, 15, 21 + 6);
  ASSERT_EQ(round.size(), 2U);
  EXPECT_EQ(round[0].first, 0);
  EXPECT_EQ(round[0].last, 4);
  EXPECT_EQ(round[1].first, 7);
  EXPECT_EQ(round[1].last, 12);
  EXPECT_NEAR(round[1].to, 5 * pi / 12, 1e-12);
  EXPECT_TRUE(drawing::curves_between(curves, hook.points, 19, 20).empty());
}

}  // namespace
}  // namespace epura::test::curve_part_test
