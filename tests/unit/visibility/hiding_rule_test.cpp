// SPDX-License-Identifier: Apache-2.0
#include "visibility/hiding_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test {
namespace {

// Of a plane that rises by 3 upwards and by half to the right.
view::ProjectedScene needle(double height) {
  view::ProjectedScene view;
  for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(0.5, height)})
    view.vertices.push_back({p.x, p.y, p.x / 2 + 3 * p.y, 1});
  return view;
}

// Heights of which the products of coordinates keep all digits.
TEST(Slope, OfANeedleIsThatOfItsPlane) {
  for (const int power : {1, 9, 10, 11, 20, 30, 39}) {
    const auto slope = visibility::slope_of(needle(std::ldexp(1.0, -power)), {{0, 1, 2}, 0});
    ASSERT_TRUE(slope) << power;
    EXPECT_EQ(*slope, Vec2(0.5, 3)) << power;
  }
}

TEST(Slope, IsMissingWhereATriangleIsALine) {
  for (const int power : {40, 41, 60})
    EXPECT_FALSE(visibility::slope_of(needle(std::ldexp(1.0, -power)), {{0, 1, 2}, 0})) << power;
  EXPECT_FALSE(visibility::slope_of(needle(0), {{0, 1, 2}, 0}));
}

}  // namespace
}  // namespace epura::test
