// SPDX-License-Identifier: Apache-2.0
#include "verify/patch.hpp"

#include <gtest/gtest.h>

namespace epura::test {
namespace {

const ConvexPolygon lower{{-1, -1}, {1, -1}, {1, 1}};
const ConvexPolygon upper{{-1, 1}, {-1, -1}, {1, 1}};  // the other way round

TEST(Patch, NothingCoversNothing) { EXPECT_DOUBLE_EQ(uncovered({}), 4); }

TEST(Patch, TwoTrianglesCoverTheSquare) {
  EXPECT_NEAR(uncovered({lower}), 2, 1e-12);
  EXPECT_NEAR(uncovered({lower, lower}), 2, 1e-12);
  EXPECT_NEAR(uncovered({lower, upper}), 0, 1e-8);
}

TEST(Patch, OverlapsCountOnce) {
  const ConvexPolygon left{{-1, -1}, {0.5, -1}, {0.5, 1}, {-1, 1}};
  const ConvexPolygon right{{-0.5, -1}, {1, -1}, {1, 0}, {-0.5, 0}};
  EXPECT_NEAR(uncovered({left, right}), 0.5, 1e-12);
}

TEST(Patch, AGapInAFanIsFound) {
  std::vector<ConvexPolygon> fan;
  const std::vector<Vec2> rim{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (std::size_t i = 0; i < 4; ++i) fan.push_back({{0.3, -0.2}, rim[i], rim[(i + 1) % 4]});
  EXPECT_NEAR(uncovered(fan), 0, 1e-8);
  fan.erase(fan.begin() + 2);
  EXPECT_NEAR(uncovered(fan), 1.3, 1e-8);
}

TEST(Patch, CornersThatCoincideChangeNothing) {
  EXPECT_NEAR(uncovered({{{-1, -1}, {1, -1}, {1, -1}, {1, 1}, {-1, 1}}}), 0, 1e-8);
}

}  // namespace
}  // namespace epura::test
