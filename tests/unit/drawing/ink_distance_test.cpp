// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: how far merging moves lines, which a drawing states as a part of its error.
#include "drawing/ink_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "base/nearest.hpp"

namespace epura::test::ink_distance_test {
namespace {

constexpr double precision = 1e-4, most = 1;

drawing::Piece piece(Vec2 from, Vec2 to, bool visible = true) {
  return {from, to, visible, true, EdgeKind::crease, 0, {0, 1}};
}

double distance(const std::vector<drawing::Piece>& before, const std::vector<drawing::Piece>& after) {
  return drawing::ink_distance(before, after, precision, most);
}

TEST(InkDistance, IsThatOfTheFarthestPointWhicheverInkItIsOf) {
  const drawing::Piece kept = piece({0, 0}, {10, 0}), left_out = piece({0, 0.03}, {10, 0.05});
  EXPECT_NEAR(distance({kept, left_out}, {kept}), 0.05, 2 * precision);
  EXPECT_NEAR(distance({kept}, {kept, left_out}), 0.05, 2 * precision);
  EXPECT_EQ(distance({kept, left_out}, {left_out, kept}), 0);
}

// Both ends are near ink, and the middle is not.
TEST(InkDistance, IsFoundBetweenTheEnds) {
  const drawing::Piece roof = piece({0, 0}, {8, 0});
  EXPECT_NEAR(distance({roof}, {piece({0, 0}, {4, 0.3}), piece({4, 0.3}, {8, 0})}), 0.3, 2 * precision);
}

TEST(InkDistance, ComparesVisibleInkWithVisibleInk) {
  const drawing::Piece hidden = piece({0, 0.1}, {10, 0.1}, false), visible = piece({0, 0}, {10, 0});
  EXPECT_NEAR(distance({hidden, visible}, {visible}), 0.1, 2 * precision);
  EXPECT_NEAR(distance({piece({0, 0.1}, {10, 0.1}), visible}, {hidden, visible}), 0.1, 2 * precision);
  EXPECT_EQ(distance({visible}, {}), most);
}

// Against points of the lines, each 1e-4 from the next.
TEST(InkDistance, OfRandomLinesIsThatOfTheirPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 0.7);
  for (int round = 0; round < 40; ++round) {
    std::vector<drawing::Piece> one, other;
    for (int i = 0; i < 4; ++i) {
      one.push_back(piece({place(random), place(random)}, {place(random), place(random)}));
      other.push_back(piece({place(random), place(random)}, {place(random), place(random)}));
    }
    double expected = 0;
    for (const auto& [from, to] : {std::pair{&one, &other}, std::pair{&other, &one}})
      for (const drawing::Piece& p : *from)
        for (int i = 0; i <= 10000; ++i) {
          double least = HUGE_VAL;
          for (const drawing::Piece& q : *to)
            least = std::min(least, distance_to_segment(p.from + i * 1e-4 * (p.to - p.from), q.from, q.to));
          expected = std::max(expected, least);
        }
    EXPECT_NEAR(distance(one, other), expected, 2 * precision);
  }
}

}  // namespace
}  // namespace epura::test::ink_distance_test
