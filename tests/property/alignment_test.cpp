// SPDX-License-Identifier: Apache-2.0
// Alignment and view: cases whose visible and hidden lengths are known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

namespace epura::test::alignment_test {
namespace {

const double r = std::sqrt(2.0 / 3.0);
const Vec3 diagonal(1, 1, 1);

// A wide ground far below, so that lines beside the plates lie inside the drawing.
Shape ground() { return plate(-4, -4, 4, 4, -10); }

TEST(Alignment, CubeAlongItsDiagonal) {
  for (const bool other : {false, true}) {
    const Result cube = draw(world_of(triangulated_cube(other)), orthographic(diagonal));
    EXPECT_NEAR(cube.visible(), 9 * r, 1e-9);
    EXPECT_NEAR(cube.hidden_length(), 3 * r, 1e-9);
    EXPECT_EQ(cube.pieces(true), 9);
    EXPECT_EQ(cube.pieces(false), 3);
  }
}

TEST(Alignment, CubeFaceOn) {
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    const Result cube = draw(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic(axis));
    EXPECT_NEAR(cube.visible(), 4, 1e-12);
    EXPECT_EQ(cube.pieces(true), 4);
    EXPECT_EQ(cube.pieces(false), 0);
  }
}

TEST(Alignment, CubeAndItsCopyBehind) {
  Shape both = box({0, 0, 0}, {2, 2, 2});
  both.add(box({1, 1, 1}, {3, 3, 3}));
  const edges::EdgeOptions no_intersections{.intersection = false};
  const Result result = draw(world_of(both), orthographic(diagonal), no_intersections);
  EXPECT_NEAR(result.visible(), 18 * r, 1e-8);
  EXPECT_NEAR(result.hidden_length(), 6 * r, 1e-8);
}

TEST(Alignment, LineAlmostAlongABorder) {
  for (double e = 1e-1; e > 2e-9; e /= 10) {
    const auto spans =
        hidden_of_line(world_of({plate(0, 0, 1, 1, 1), ground()}), from_above(), {-1, e * -1.5, 0}, {2, e * 1.5, 0});
    ASSERT_EQ(spans.size(), 1U) << e;
    // Where the line crosses the border at angle e, the grid (1e-9 of the drawing) moves the crossing by cell / e.
    EXPECT_NEAR(spans[0][0], 0.5, 1e-13 / e) << e;
    EXPECT_NEAR(spans[0][1], 2.0 / 3, 1e-9) << e;
  }
}

TEST(Alignment, LineAlongABorderLeavesTheInkUnchanged) {
  for (const double e : {1e-10, 1e-11, 1e-12, 0.0}) {
    const auto spans =
        hidden_of_line(world_of({plate(0, 0, 1, 1, 1), ground()}), from_above(), {-1, e * -1.5, 0}, {2, e * 1.5, 0});
    // It coincides with the visible border from x = 0 to 1; outside it must be visible.
    for (const auto& span : spans) {
      EXPECT_GE(span[0], 1.0 / 3 - 1e-7);
      EXPECT_LE(span[1], 2.0 / 3 + 1e-7);
    }
  }
}

TEST(Alignment, LinePiercingAPlate) {
  const world::World world = world_of({plate(-2, -1, 2, 1, 0), ground()});
  for (double slope = 1; slope > 1e-6; slope /= 10) {
    const auto spans = hidden_of_line(world, from_above(), {-1, 0, -slope}, {1, 0, slope});
    ASSERT_EQ(spans.size(), 1U) << slope;
    EXPECT_EQ(spans[0][0], 0) << slope;
    // The contact tolerance (four cells, 8 units wide) lengthens the visible part by tolerance / (2 slope).
    EXPECT_NEAR(spans[0][1], 0.5, 8 * 0x1p-27 / (2 * slope)) << slope;
    EXPECT_LE(spans[0][1], 0.5) << slope;
  }
  for (const double slope : {1e-10, 1e-13, 1e-15})
    EXPECT_TRUE(hidden_of_line(world, from_above(), {-1, 0, -slope}, {1, 0, slope}).empty()) << slope;
}

TEST(Alignment, LineInAPlateIsVisible) {
  const world::World world = world_of({plate(-2, -1, 2, 1, 0), ground()});
  EXPECT_TRUE(hidden_of_line(world, from_above(), {-1, -0.3, 0}, {1, 0.7, 0}).empty());
}

TEST(Alignment, LineBehindANarrowPlate) {
  for (double w = 1e-1; w > 1e-6; w /= 10) {
    const world::World world = world_of({plate(0, -1, w, 1, 1), ground()});
    const auto behind = hidden_of_line(world, from_above(), {-1, 0, 0}, {1, 0, 0});
    ASSERT_EQ(behind.size(), 1U) << w;
    EXPECT_NEAR(2 * (behind[0][1] - behind[0][0]), w, 1e-9) << w;
  }
}

TEST(Alignment, LineThroughTheHubOfAFan) {
  for (const int blades : {3, 7, 16, 101}) {
    Shape fan{{{0, 0, 1}}, {}, {}};
    for (int i = 0; i < blades; ++i) {
      const double a = 2 * M_PI * i / blades;
      fan.points.push_back({std::cos(a), std::sin(a), 1});
      fan.faces.push_back({0, i + 1, (i + 1) % blades + 1});
    }
    const auto spans = hidden_of_line(world_of({fan, ground()}), from_above(), {-2, 0, 0}, {2, 0, 0});
    ASSERT_EQ(spans.size(), 1U) << blades;
    EXPECT_LT(spans[0][0], 0.4);
    EXPECT_NEAR(spans[0][1], 0.75, 1e-9) << blades;
  }
}

TEST(Alignment, LineThroughTheVertexOfABowTie) {
  const Shape bow{{{0, 0, 1}, {-0.5, 1, 1}, {0.5, 1, 1}, {-0.5, -1, 1}, {0.5, -1, 1}}, {{0, 2, 1}, {0, 3, 4}}, {}};
  EXPECT_TRUE(hidden_of_line(world_of({bow, ground()}), from_above(), {-1, 0, 0}, {1, 0, 0}).empty());
}

TEST(Alignment, PlateCloseUnderALargerPlate) {
  for (double e = 1e-3; e > 1e-16; e /= 10) {
    const Result result = draw(world_of({plate(-0.5, -0.5, 0.5, 0.5, 0), plate(-1, -1, 1, 1, e)}), from_above());
    const double tolerance = 4 * result.view.cell / result.view.map.normalisation;
    EXPECT_NEAR(result.hidden_length(), e > tolerance ? 4 : 0, 1e-9) << e;
    EXPECT_NEAR(result.visible(), e > tolerance ? 8 : 12, 1e-9) << e;
  }
}

TEST(Alignment, ZigzagSheet) {
  // Waves of slope 1 along x, seen from above at a slope of 1/2: each crest hides the next valley.
  const int waves = 6;
  Shape sheet;
  for (int i = 0; i <= 2 * waves; ++i) {
    sheet.points.push_back({0.5 * i, 0, i % 2 == 0 ? 0.0 : 0.5});
    sheet.points.push_back({0.5 * i, 1, i % 2 == 0 ? 0.0 : 0.5});
    if (i > 0) sheet.faces.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  const edges::EdgeOptions folds{.contour = true, .boundary = false, .crease = true, .intersection = false};
  const Result result = draw(world_of(sheet), orthographic({2, 0, 1}), folds);
  // Crests are visible, and so would be the front border; valleys between two crests are hidden.
  EXPECT_NEAR(result.visible(), waves, 1e-9);
  EXPECT_NEAR(result.hidden_length(), waves - 1, 1e-9);
}

TEST(Alignment, TurningThroughAnAlignmentKeepsTheInk) {
  for (const double angle : {1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-7}) {
    const Result cube = draw(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic({1 + angle, 1, 1 - angle}));
    EXPECT_NEAR(cube.visible(), 9 * r, 1e-6) << angle;
    EXPECT_NEAR(cube.hidden_length(), 3 * r, 2e-6) << angle;
  }
}

TEST(Alignment, LongEdgesCrossingAtASmallAngle) {
  for (double a = 1e-3; a > 1e-7; a /= 10) {
    // The upper plate's border runs at angle a over the line y = 0.
    const Shape upper{{{-1, -a, 1}, {1, a, 1}, {1, 1, 1}, {-1, 1, 1}}, {{0, 1, 2, 3}}, {}};
    const auto spans = hidden_of_line(world_of({upper, ground()}), from_above(), {-2, 0, 0}, {2, 0, 0});
    ASSERT_EQ(spans.size(), 1U) << a;
    EXPECT_NEAR(spans[0][0], 0.25, 1e-7) << a;
    EXPECT_NEAR(spans[0][1], 0.5, 1e-15 / a) << a;
  }
}

}  // namespace
}  // namespace epura::test::alignment_test
