// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "verify/line_marks.hpp"

namespace epura::test::upper_envelope_test {
namespace {

verify::Slice slice_of(const std::vector<std::array<double, 4>>& pieces) {
  verify::Slice slice;
  for (const auto& [u0, u1, z0, z1] : pieces) slice.pieces.push_back({0, {u0, u1}, {z0, z1}, {-1, -1}});
  return slice;
}

TEST(UpperEnvelope, NothingOverNothing) {
  EXPECT_TRUE(verify::upper_envelope({}).empty());
  EXPECT_TRUE(verify::upper_envelope(slice_of({{1, 1, 0, 5}})).empty());
}

TEST(UpperEnvelope, PiecesThatCrossTakeTurns) {
  const auto seen = verify::upper_envelope(slice_of({{0, 4, 0, 4}, {1, 3, 3, 1}, {6, 7, 0, 0}}));
  ASSERT_EQ(seen.size(), 4);
  EXPECT_EQ(seen[0].piece, 0);
  EXPECT_EQ(seen[0].to, 1);
  EXPECT_EQ(seen[1].piece, 1);
  EXPECT_EQ(seen[1].to, 2);
  EXPECT_EQ(seen[2].piece, 0);
  EXPECT_EQ(seen[2].to, 4);
  EXPECT_EQ(seen[3].from, 6);
}

// At random places, against all pieces.
TEST(UpperEnvelope, IsTheHighestOfAll) {
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 0x1p32; };
  for (int round = 0; round < 50; ++round) {
    std::vector<std::array<double, 4>> pieces;
    for (int i = 0; i < 40; ++i) {
      const double from = uniform();
      pieces.push_back({from, from + 0.3 * uniform(), uniform(), uniform()});
    }
    const verify::Slice slice = slice_of(pieces);
    const auto seen = verify::upper_envelope(slice);
    for (int i = 0; i < 200; ++i) {
      const double u = 1.3 * uniform();
      double highest = -1, here = -1;
      for (const verify::SlicePiece& piece : slice.pieces)
        if (piece.u[0] < u && u < piece.u[1]) highest = std::max(highest, piece.depth_at(u));
      for (const verify::SeenPart& part : seen)
        if (part.from < u && u < part.to) here = slice.pieces[part.piece].depth_at(u);
      EXPECT_NEAR(here, highest, 1e-12);
    }
  }
}

// The floor below the viewer ends beside the plane of the viewer, where its image is almost infinite.
TEST(SlicePiece, DepthIsExactBesideTheEndThatIsNear) {
  const verify::SlicePiece floor{0, {-0x1p45, -0x1p4}, {0x1p45, -0x1p2}, {-1, -1}};
  for (const double u : {-0x1p4, -17.0, -17.125, -1000.0}) {
    const long double along =
        (u - static_cast<long double>(floor.u[1])) / (floor.u[1] - static_cast<long double>(floor.u[0]));
    const long double depth = floor.depth[1] + along * (floor.depth[1] - static_cast<long double>(floor.depth[0]));
    EXPECT_NEAR(floor.depth_at(u), static_cast<double>(depth), 1e-12) << u;
  }
  EXPECT_EQ(floor.depth_at(floor.u[0]), floor.depth[0]);
  EXPECT_EQ(floor.depth_at(floor.u[1]), floor.depth[1]);
}

}  // namespace
}  // namespace epura::test::upper_envelope_test
