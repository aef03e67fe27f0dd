// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "verify/judge.hpp"

namespace epura::test::patch_test {
namespace {

const verify::ConvexPolygon lower{{-1, -1}, {1, -1}, {1, 1}};
const verify::ConvexPolygon upper{{-1, 1}, {-1, -1}, {1, 1}};  // the other way round

TEST(Patch, NothingCoversNothing) { EXPECT_DOUBLE_EQ(verify::uncovered({}), 4); }

TEST(Patch, TwoTrianglesCoverTheSquare) {
  EXPECT_NEAR(verify::uncovered({lower}), 2, 1e-12);
  EXPECT_NEAR(verify::uncovered({lower, lower}), 2, 1e-12);
  EXPECT_NEAR(verify::uncovered({lower, upper}), 0, 1e-8);
}

TEST(Patch, OverlapsCountOnce) {
  const verify::ConvexPolygon left{{-1, -1}, {0.5, -1}, {0.5, 1}, {-1, 1}};
  const verify::ConvexPolygon right{{-0.5, -1}, {1, -1}, {1, 0}, {-0.5, 0}};
  EXPECT_NEAR(verify::uncovered({left, right}), 0.5, 1e-12);
}

TEST(Patch, AGapInAFanIsFound) {
  std::vector<verify::ConvexPolygon> fan;
  const std::vector<Vec2> rim{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (std::size_t i = 0; i < 4; ++i) fan.push_back({{0.3, -0.2}, rim[i], rim[(i + 1) % 4]});
  EXPECT_NEAR(verify::uncovered(fan), 0, 1e-8);
  fan.erase(fan.begin() + 2);
  EXPECT_NEAR(verify::uncovered(fan), 1.3, 1e-8);
}

TEST(Patch, CornersThatCoincideChangeNothing) {
  EXPECT_NEAR(verify::uncovered({{{-1, -1}, {1, -1}, {1, -1}, {1, 1}, {-1, 1}}}), 0, 1e-8);
}

}  // namespace
}  // namespace epura::test::patch_test
