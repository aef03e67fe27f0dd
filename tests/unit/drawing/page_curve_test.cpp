// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: ends of lines on the wrong side of a contour, or far from it.
#include "drawing/page_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test::page_curve_test {
namespace {

using namespace drawing;

// The quarter of an ellipse of semi-axes 4 and 2 from (4, 0) to (0, 2).
PageCurve quarter() { return PageCurve(CurvePart{0, 1, {0, 0}, {4, 0}, {0, 2}, 0, M_PI / 2}); }

void expect_at(const std::optional<Vec2>& place, const Vec2& expected) {
  ASSERT_TRUE(place);
  EXPECT_LT(glm::distance(*place, expected), 1e-9);
}

TEST(PageCurve, CrossesNearAPoint) {
  const PageCurve line({-5, 1}, {5, 1});
  const double x = 4 * std::sqrt(0.75);
  expect_at(crossing_near(line, quarter(), {3, 1}), {x, 1});
  expect_at(crossing_near(line, quarter(), {-3, 1}), {-x, 1});
  EXPECT_FALSE(crossing_near(line, PageCurve({-5, 2}, {5, 2}), {0, 1}));
}

TEST(PageCurve, EndsWhereItsPartDoes) {
  const double x = 4 * std::sqrt(0.75);
  EXPECT_TRUE(quarter().is_in_part({x, 1}));
  EXPECT_FALSE(quarter().is_in_part({x, -1}));
  EXPECT_FALSE(quarter().is_in_part({-x, 1}));
  EXPECT_LT(glm::distance(quarter().end_near({x, -1}), {4, 0}), 1e-12);
  EXPECT_LT(glm::distance(quarter().end_near({-x, 1}), {0, 2}), 1e-12);
  const PageCurve line({0, 0}, {2, 0});
  EXPECT_TRUE(line.is_in_part({1, 0}));
  EXPECT_FALSE(line.is_in_part({3, 0}));
  EXPECT_EQ(line.end_near({3, 0}), Vec2(2, 0));
}

}  // namespace
}  // namespace epura::test::page_curve_test
