// SPDX-License-Identifier: Apache-2.0
#include "study/methods/pixel_walk.hpp"

#include <gtest/gtest.h>

namespace epura::test::pixel_walk_test {
namespace {

using Part = std::array<double, 2>;
using Pixel = std::array<int, 2>;

TEST(PixelWalk, TakesOneStepAColumn) {
  const study::PixelWalk walk({0.25, 3.5}, {4.25, 5.5});
  ASSERT_EQ(walk.steps(), 4);
  EXPECT_EQ(walk.pixel(0), (Pixel{0, 3}));
  EXPECT_EQ(walk.pixel(3), (Pixel{3, 5}));
  EXPECT_EQ(walk.position(1), 0.3125);
  EXPECT_EQ(walk.part(0), (Part{0, 0.1875}));
  EXPECT_EQ(walk.part(1), (Part{0.1875, 0.4375}));
  EXPECT_EQ(walk.part(3), (Part{0.6875, 1})) << "to the end";
}

TEST(PixelWalk, GoesBackwardsAndUpwards) {
  const study::PixelWalk walk({2.5, 8.75}, {1.5, 2.75});
  ASSERT_EQ(walk.steps(), 6);
  EXPECT_EQ(walk.pixel(0), (Pixel{2, 8}));
  EXPECT_EQ(walk.pixel(5), (Pixel{1, 3}));
  EXPECT_EQ(walk.part(0)[1], walk.part(1)[0]);
  EXPECT_EQ(walk.part(5)[1], 1);
}

TEST(PixelWalk, MeetsNoMiddleAndTakesOneStepAllTheSame) {
  for (const auto& [p, q] : {std::pair{Vec2(1.6, 2.1), Vec2(2.4, 2.2)}, {Vec2(1.2, 2.2), Vec2(1.2, 2.2)}}) {
    const study::PixelWalk walk(p, q);
    ASSERT_EQ(walk.steps(), 1);
    EXPECT_EQ(walk.part(0), (Part{0, 1}));
    EXPECT_EQ(walk.position(0), 0.5);
  }
}

}  // namespace
}  // namespace epura::test::pixel_walk_test
