// SPDX-License-Identifier: Apache-2.0
// What slots leave of rounded edges and chamfers, and from where flats of shafts are measured.
#include "features/part_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recognised.hpp"

namespace epura::test::part_features_test {
namespace {

TEST(RoundsFeature, ReachOnlyWhereSlotsLeftThem) {
  features::RoundFeature round{0, Vec3(0), Vec3(0, 0, 1), 10, 1, {0, 90}};
  EXPECT_TRUE(round.reaches(Vec3(1, 0, 0))) << "a full turn";
  round.sectors = {{Vec3(0, 1, 0), 80}, {Vec3(0, -1, 0), 80}};
  EXPECT_FALSE(round.reaches(Vec3(1, 0, 0)));
  EXPECT_FALSE(round.reaches(Vec3(-1, 0, 0)));
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(round.reaches(Vec3(0, side, 0)));
    EXPECT_TRUE(round.reaches(glm::normalize(Vec3(1, side, 0))));
  }
}

/// A circle, with a flat at x = 4 if it `has_flat`.
std::vector<Vec2> section(double radius, bool has_flat) {
  const double half = has_flat ? std::acos(4 / radius) : 0;
  constexpr int steps = 72;
  std::vector<Vec2> outline;
  for (int i = 0; i <= steps; ++i) {
    const double angle = half + (2 * pi - 2 * half) * i / steps;
    if (has_flat || i < steps) outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

/// A part of a shaft, up to the next height.
struct ShaftPart {
  double radius;
  bool has_flat;
  double height;
};

// From where the flat is measured, with a head of radius 8 at the end.
std::optional<double> other_side(const std::vector<ShaftPart>& shaft) {
  std::vector<Part> parts;
  double from = 0;
  for (const ShaftPart& part : shaft) {
    parts.push_back(moved(prism(section(part.radius, part.has_flat), part.height - from), {0, 0, from}));
    from = part.height;
  }
  parts.push_back(moved(prism(section(8, false), 6), {0, 0, from}));
  std::optional<double> found;
  for (const features::LevelFeature& level : features::find_part_features(world_of(together(parts))).levels)
    if (level.axis == 0 && std::abs(level.at - 4) < 1e-9) found = level.other_side;
  return found;
}

TEST(FlatsFeature, AreMeasuredFromTheOtherSideOfTheirShaft) {
  const auto expect = [](const std::vector<ShaftPart>& shaft, double side, const char* what) {
    const auto found = other_side(shaft);
    ASSERT_TRUE(found) << what;
    EXPECT_NEAR(*found, side, 1e-9) << what;
  };
  expect({{5, false, 10}, {5, true, 20}, {5, false, 30}}, -5, "in the middle");
  expect({{5, true, 12}, {5, false, 30}}, -5, "at the end");
  expect({{5, false, 5}, {5, true, 12}, {6, true, 20}, {6, false, 30}}, -5, "across a step");
  expect({{5, true, 8}, {4.5, false, 10}, {5, true, 18}, {5, false, 30}}, -5, "on both sides of a groove");
  expect({{6, false, 5}, {5, true, 12}, {6, false, 20}}, -5, "not from a thicker part beside it");
}

// Between a collar and a thinner part, as in an undercut, or between equal ones.
TEST(LevelsFeature, AreTheSidesOfANeck) {
  for (const double radius : {13.0, 21.0}) {
    const world::World world =
        world_of(revolved({{0, 0}, {21, 0}, {21, 32}, {11, 32}, {11, 35}, {radius, 35}, {radius, 71}, {0, 71}}, 48));
    for (const features::LevelFeature& level : features::find_part_features(world).levels) {
      ASSERT_TRUE(level.partner) << level.at;
      EXPECT_NEAR(*level.partner, 67 - level.at, 1e-9) << level.at;
    }
  }
}

// A shaft of radius 8 with a chamfer of 1 at its end, of which a keyway takes 60 degrees.
TEST(ConeFeatures, MayBeInterrupted) {
  for (const double sweep : {2 * pi, 5 * pi / 3}) {
    const features::PartFeatures found =
        features::find_part_features(world_of(revolved({{0, 0}, {8, 0}, {8, 20}, {7, 21}, {0, 21}}, 48, sweep)));
    ASSERT_EQ(found.chamfers.size(), 1U) << sweep;
    EXPECT_EQ(found.cones.size(), 0U) << sweep;
    EXPECT_NEAR(found.chamfers[0].angle, 45, 1e-6) << sweep;
    EXPECT_NEAR(found.chamfers[0].radii[0], 7, 1e-6) << sweep;
    EXPECT_NEAR(found.chamfers[0].radii[1], 8, 1e-6) << sweep;
  }
}

// A cap of 0.1 on a ball of 6 is as near to one with a radius of 6.06 as a thousandth.
TEST(RadiusDoubt, IsLargeForSmallCaps) {
  surfaces::PartFace cap;
  cap.surface.kind = surfaces::SurfaceKind::sphere;
  cap.surface.radius = 6;
  cap.residual = 1e-3;
  for (const double height : {0.1, 3.0, 6.0, 12.0}) {
    cap.area = 2 * std::numbers::pi * 6 * height;
    EXPECT_NEAR(features::radius_doubt(cap), 1e-3 * std::max(6 / height, 1.0), 1e-12);
  }
}

// Its apex is where rounding leaves it: a circle there would have a diameter of 0.
TEST(ConeFeatures, ThatEndInATipHaveOneCircle) {
  for (const char* turn : {"", "rotate:x,30 rotate:z,20"}) {
    const world::World world = world_of(revolved({{0, 0}, {10, 0}, {0, 25}}, 48), turn);
    const features::PartFeatures found = features::find_part_features(world);
    ASSERT_EQ(found.cones.size(), 1U);
    EXPECT_EQ(found.cones[0].radii[0], 0);
    EXPECT_NEAR(found.cones[0].radii[1], 10, 1e-6);
  }
}

}  // namespace
}  // namespace epura::test::part_features_test
