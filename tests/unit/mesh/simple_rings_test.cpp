// SPDX-License-Identifier: Apache-2.0
#include "mesh/simple_rings.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace epura::simple_rings_test {
namespace {

using Rings = std::vector<std::vector<int>>;

// A square 0 to 3, a square 4 to 7 inside of it the other way round, and a triangle 2, 8, 9 that touches it.
const mesh::Points points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0},
                          {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {6, 4, 0}, {6, 6, 0}};

Rings rings(const std::vector<int>& ring) { return mesh::simple_rings(ring, points); }

TEST(SimpleRings, AreDividedWhereLoopsTouch) {
  EXPECT_EQ(rings({0, 1, 2, 8, 9, 2, 3}), (Rings{{2, 8, 9}, {0, 1, 2, 3}}));
  EXPECT_EQ(rings({8, 9, 2, 3, 0, 1, 2}), (Rings{{2, 3, 0, 1}, {8, 9, 2}}));
}

TEST(SimpleRings, KeepBridgesToHoles) {
  const std::vector<int> keyhole{0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  EXPECT_EQ(rings(keyhole), Rings{keyhole});
}

TEST(SimpleRings, LeaveOutWaysThereAndBack) {
  EXPECT_EQ(rings({0, 1, 8, 1, 2, 3}), (Rings{{0, 1, 2, 3}}));
  EXPECT_EQ(rings({0, 1, 8, 9, 8, 1, 2, 3}), (Rings{{0, 1, 2, 3}}));
  EXPECT_EQ(rings({8, 1, 2, 3, 0, 1}), (Rings{{1, 2, 3, 0}})) << "around the end of the ring";
  EXPECT_EQ(rings({1, 2, 3, 0, 1, 8}), (Rings{{1, 2, 3, 0}}));
  EXPECT_EQ(rings({0, 1, 8, 1}), Rings{}) << "nothing else";
}

TEST(SimpleRings, HoldLoopsOnceThatAreGoneRoundAgain) {
  EXPECT_EQ(rings({0, 1, 2, 3, 0, 1, 2, 3}), (Rings{{0, 1, 2, 3}}));
  EXPECT_EQ(rings({0, 1, 2, 8, 9, 2, 8, 9, 2, 3}), (Rings{{2, 8, 9}, {0, 1, 2, 3}}));
  EXPECT_EQ(rings({0, 1, 2, 8, 9, 2, 3, 0, 1, 2, 3}), (Rings{{2, 8, 9}, {0, 1, 2, 3}}));
}

TEST(SimpleRings, RepeatCorners) {
  EXPECT_TRUE(mesh::repeats_corner(std::vector<int>{0, 1, 2, 1}));
  EXPECT_FALSE(mesh::repeats_corner(std::vector<int>{0, 1, 2, 3}));
  std::vector<int> many;
  for (int i = 0; i < 40; ++i) many.push_back(i);
  EXPECT_FALSE(mesh::repeats_corner(many));
  many.push_back(17);
  EXPECT_TRUE(mesh::repeats_corner(many));
}

}  // namespace
}  // namespace epura::simple_rings_test
