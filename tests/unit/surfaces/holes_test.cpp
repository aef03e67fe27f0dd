// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: callouts of holes.
#include "surfaces/holes.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace epura::holes_test {
namespace {

using namespace test;

std::vector<surfaces::Hole> holes_of(const Part& part) {
  const mesh::Mesh mesh = part.mesh();
  return surfaces::find_holes(mesh, surfaces::recognise_faces(mesh));
}

TEST(Holes, ABoreGoesThrough) {
  const auto holes = holes_of(plate_with_hole(20, 5, 8, 8));
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_TRUE(holes[0].through);
  ASSERT_EQ(holes[0].diameters.size(), 1U);
  EXPECT_NEAR(holes[0].diameters[0], 16, 1e-9);
  EXPECT_NEAR(glm::distance(holes[0].from, holes[0].to), 5, 1e-9);
}

// Round blocks of radius 20 and height 30, bored from above.
Part bored(const std::vector<Vec2>& bore) { return revolved(joined({{{0, 0}, {20, 0}, {20, 30}}, bore}), 36); }

TEST(Holes, VerticesOfTheirWallsMayLieAtManyAngles) {
  // Ten rings of facets of 11.25 degrees, each turned a little farther: together, their vertices have 320 angles, but
  // none in the last two thirds of any facet of the rim.
  std::vector<Vec2> wall;
  for (int i = 0; i <= 9; ++i) wall.emplace_back(4, 30 - 10.0 / 3 * i);
  Part part = revolved(joined({{{4, 0}, {20, 0}, {20, 30}}, wall}), 32);
  part.triangulate().move([](const Vec3& p) {
    const double angle = std::hypot(p.x, p.y) < 5 ? p.z / 30 / 3 * 2 * pi / 32 : 0;
    return Vec3(p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle), p.z);
  });
  const auto holes = holes_of(part);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_TRUE(holes[0].through);
  EXPECT_NEAR(holes[0].diameters.at(0), 8, 1e-9);
}

TEST(Holes, ADrillPointAndABottomEndThem) {
  for (const double tip : {12.0, 10.0}) {
    const auto holes = holes_of(bored({{4, 30}, {4, 12}, {0, tip == 12 ? 12 : tip}}));
    ASSERT_EQ(holes.size(), 1U) << tip;
    EXPECT_FALSE(holes[0].through);
    EXPECT_NEAR(holes[0].diameters.at(0), 8, 1e-9);
    EXPECT_NEAR(glm::distance(holes[0].from, holes[0].to), 30 - tip, 1e-9);
  }
}

// The apex of the drill point is beside the axis by the rounding of the file.
TEST(Holes, ADrillPointEndsThemWhereverThePartLies) {
  for (const double step : {1e-9, 1e-6, 1e-4})
    for (int place = 0; place < 12; ++place) {
      Part part = bored({{4, 30}, {4, 12}, {0, 9.6}});
      part.triangulate().move(
          [&](const Vec3& p) { return glm::round((p + Vec3(13.71 * place, 11.37 * place, 1.0 / 3)) / step) * step; });
      const auto holes = holes_of(part);
      ASSERT_EQ(holes.size(), 1U) << step << " " << place;
      EXPECT_FALSE(holes[0].through) << step << " " << place;
      EXPECT_NE(holes[0].closed[0], holes[0].closed[1]) << step << " " << place;
    }
}

// The plane around a through hole is cut into triangles whose sharp corners may point at its axis: what their sides
// would prolong closes no end.
TEST(Holes, ANeedleThatPointsAtTheirAxisEndsThemNot) {
  const Vec3 axis(0, 0, 1);
  const double slack = 0.016;  // of a file with three decimals
  const std::array<Vec3, 3> needle{Vec3(-100, -0.1, 7), Vec3(-100, 0.1, 7), Vec3(-10, 0, 7)};
  EXPECT_FALSE(surfaces::height_on_axis(needle, axis, slack));
  EXPECT_FALSE(surfaces::height_on_axis({needle[1], needle[0], needle[2]}, axis, slack));
  for (const double way : {9.99, 30.0}) {
    std::array<Vec3, 3> moved = needle;
    for (Vec3& corner : moved) corner.x += way;
    const auto height = surfaces::height_on_axis(moved, axis, slack);
    ASSERT_TRUE(height) << way;
    EXPECT_NEAR(*height, 7, 1e-9) << way;
  }
}

TEST(Holes, StepsAndCountersinksBelongTogether) {
  const auto holes = holes_of(revolved({{4, 0}, {20, 0}, {20, 30}, {9, 30}, {7, 28}, {7, 20}, {4, 20}, {4, 0}}, 36));
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_TRUE(holes[0].through);
  EXPECT_EQ(holes[0].faces.size(), 3U);
  ASSERT_EQ(holes[0].diameters.size(), 2U);
  EXPECT_NEAR(holes[0].diameters[0], 8, 1e-9);
  EXPECT_NEAR(holes[0].diameters[1], 14, 1e-9);
  EXPECT_NEAR(glm::distance(holes[0].from, holes[0].to), 30, 1e-9);
}

// The narrow bore is found first: the face at its other end is no step, whichever comes first.
TEST(Holes, AStepMayBeFarWiderThanTheBoreBehind) {
  const auto holes = holes_of(revolved({{2, 0}, {30, 0}, {30, 45}, {9, 45}, {9, 40}, {2, 40}, {2, 0}}, 36));
  ASSERT_EQ(holes.size(), 1U);
  ASSERT_EQ(holes[0].diameters.size(), 2U);
  EXPECT_NEAR(glm::distance(holes[0].from, holes[0].to), 45, 1e-9);
}

TEST(Holes, ShaftsAndFilletsAreNone) {
  EXPECT_TRUE(holes_of(revolved({{0, 0}, {5, 0}, {5, 8}, {0, 8}}, 24)).empty());
  EXPECT_TRUE(
      holes_of(revolved(joined({{{0, 0}, {20, 0}}, arc({20, 5}, 3, -90, -180, 5), {{17, 20}, {0, 20}}}), 48)).empty());
}

}  // namespace
}  // namespace epura::holes_test
