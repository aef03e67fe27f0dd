// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: overall dimensions of what is round.
#include "features/true_extents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "recognised.hpp"
#include "world/facet_heights.hpp"

namespace epura::true_extents_test {
namespace {

using namespace test;

void expect_extent(const features::Extent& extent, double from, double to, features::ExtentForm form) {
  EXPECT_NEAR(extent.from, from, 1e-7);
  EXPECT_NEAR(extent.to, to, 1e-7);
  EXPECT_EQ(extent.form, form);
}

constexpr auto length = features::ExtentForm::length, diameter = features::ExtentForm::diameter,
               sphere = features::ExtentForm::sphere;

const Part shaft = revolved({{0, 0}, {40, 0}, {40, 30}, {0, 30}}, 26);

TEST(TrueExtents, AShaftHasItsDiameter) {
  // Turned by half a step no corner lies on x; with 26 corners none lies on y, either.
  const world::World world = world_of(shaft, "rotate:z,6.923076923076923");
  EXPECT_LT(world.box.size().x, 79.5);
  const auto extents = features::true_extents(world);
  expect_extent(extents[0], -40, 40, diameter);
  expect_extent(extents[1], -40, 40, diameter);
  expect_extent(extents[2], 0, 30, length);
  EXPECT_TRUE(extents[0].is_same_as(extents[1]));
  EXPECT_FALSE(extents[0].is_same_as(extents[2]));
}

TEST(TrueExtents, ModelsMayBeScaledAndMirroredButNotStretched) {
  const auto mirrored = features::true_extents(world_of(shaft, "scale:-2,2,2 rotate:z,5 translate:100,0,0"));
  expect_extent(mirrored[0], 20, 180, diameter);
  expect_extent(mirrored[2], 0, 60, length);
  const world::World stretched = world_of(shaft, "rotate:z,5 scale:2,1,1");
  const auto extents = features::true_extents(stretched);
  for (int axis = 0; axis < 3; ++axis)
    expect_extent(extents[axis], stretched.box.min[axis], stretched.box.max[axis], length);
}

TEST(TrueExtents, AnInclinedShaftReachesAsItsRims) {
  // Its axis leans by 30 degrees in the plane x, z: rims reach 40 cos 30 along x and 40 sin 30 along z.
  const auto extents = features::true_extents(world_of(shaft, "rotate:z,3 rotate:y,30"));
  const double sine = 0.5, cosine = std::sqrt(0.75);
  expect_extent(extents[0], -40 * cosine, 40 * cosine + 30 * sine, length);
  expect_extent(extents[1], -40, 40, diameter);
  expect_extent(extents[2], -40 * sine, 40 * sine + 30 * cosine, length);
}

TEST(TrueExtents, OfACone) {
  const auto extents = features::true_extents(world_of(revolved({{0, 0}, {40, 0}, {10, 30}, {0, 30}}, 25)));
  expect_extent(extents[0], -40, 40, diameter);
  expect_extent(extents[1], -40, 40, diameter);
}

TEST(TrueExtents, OfASphere) {
  // Neither poles nor an equator lie on the axes of the world.
  std::vector<Vec2> profile = arc({0, 0}, 20, -90, 90, 13);
  profile.front().x = profile.back().x = 0;
  const auto extents = features::true_extents(world_of(revolved(profile, 25), "rotate:x,20 rotate:y,33"));
  for (const features::Extent& extent : extents) expect_extent(extent, -20, 20, sphere);
  EXPECT_TRUE(extents[0].is_same_as(extents[2]));
}

// Its rims belong to the sphere, but the flats are planes.
TEST(TrueExtents, FlatsOfASphereAreNoDiameter) {
  const double angle = std::asin(0.8) * 180 / pi;
  const auto extents =
      features::true_extents(world_of(revolved(joined({{{0, -8}}, arc({0, 0}, 10, -angle, angle, 24), {{0, 8}}}), 64)));
  expect_extent(extents[2], -8, 8, length);
  expect_extent(extents[0], -10, 10, sphere);
}

// A bore through its poles leaves the sphere its diameter: the height between the rims of the bore follows.
TEST(TrueExtents, ABoreThroughASphereLeavesItsDiameter) {
  const double angle = std::acos(0.5) * 180 / pi;
  std::vector<Vec2> profile = arc({0, 0}, 10, -angle, angle, 24);
  profile.push_back(profile.front());
  const auto extents = features::true_extents(world_of(revolved(profile, 64)));
  expect_extent(extents[2], -10, 10, sphere);
  EXPECT_TRUE(extents[2].interrupted);
  EXPECT_TRUE(extents[0].is_same_as(extents[2]));
}

TEST(TrueExtents, OfARing) {
  std::vector<Vec2> profile = arc({30, 0}, 8, 4, 364, 23);
  const Part ring = revolved(profile, 41);
  auto extents = features::true_extents(world_of(ring));
  expect_extent(extents[0], -38, 38, diameter);
  expect_extent(extents[1], -38, 38, diameter);
  expect_extent(extents[2], -8, 8, length);
  // The circle that the tube runs along reaches 30 sin 50 up where it leans by 50 degrees.
  extents = features::true_extents(world_of(ring, "rotate:x,50"));
  const double angle = 50 * pi / 180;
  expect_extent(extents[0], -38, 38, diameter);
  expect_extent(extents[1], -30 * std::cos(angle) - 8, 30 * std::cos(angle) + 8, length);
  expect_extent(extents[2], -30 * std::sin(angle) - 8, 30 * std::sin(angle) + 8, length);
}

TEST(TrueExtents, OfASlottedHeadWithARoundedEdge) {
  const auto half = [](double turn, double sweep) {
    const Vec2 across(std::cos(turn), std::sin(turn));
    return revolved(joined({{{0, 0}, {18, 0}}, arc({18, 2}, 2, -90, 90, 8), {{0, 4}}}), 40, sweep)
        .move(
            [=](const Vec3& p) { return Vec3(across.x * p.x - across.y * p.y, across.y * p.x + across.x * p.y, p.z); });
  };
  // Two parts of 160 degrees: the slot along x is where the head would reach farthest.
  const double degree = pi / 180;
  const auto slotted =
      features::true_extents(world_of(together({half(10 * degree, 160 * degree), half(190 * degree, 160 * degree)})));
  expect_extent(slotted[0], -20, 20, diameter);
  expect_extent(slotted[1], -20, 20, diameter);
  EXPECT_TRUE(slotted[0].is_same_as(slotted[1]));
  EXPECT_TRUE(slotted[0].interrupted);
  EXPECT_FALSE(slotted[1].interrupted);
  // Of half a head, nothing lies on the other side.
  const auto one = features::true_extents(world_of(half(0, pi)));
  expect_extent(one[1], 0, 20, length);
}

TEST(TrueExtents, ArcsReachOnlyWhereTheyAre) {
  // Three quarters of a disc have a diameter; what is missing lies beyond x = 0 and y = 0.
  std::vector<Vec2> outline = arc({0, 0}, 40, 90, 360, 31);
  outline.emplace_back(0, 0);
  auto extents = features::true_extents(world_of(prism(outline, 10)));
  expect_extent(extents[0], -40, 40, diameter);
  expect_extent(extents[1], -40, 40, diameter);
  // A flat at x = 32, and a slot with edges at (-32, 24) and (-32, -24).
  const double at = std::acos(0.8) * 180 / pi;
  outline = arc({0, 0}, 40, at, 180 - at, 13);
  outline.emplace_back(-20, 0);
  const std::vector<Vec2> below = arc({0, 0}, 40, 180 + at, 360 - at, 13);
  outline.insert(outline.end(), below.begin(), below.end());
  extents = features::true_extents(world_of(prism(outline, 10)));
  expect_extent(extents[0], -40, 32, length);
  expect_extent(extents[1], -40, 40, diameter);
  // 100 degrees about the downward direction.
  outline = arc({0, 0}, 40, 220, 320, 13);
  extents = features::true_extents(world_of(prism(outline, 10)));
  const double half = 40 * std::cos(40 * pi / 180);
  expect_extent(extents[0], -half, half, length);
  expect_extent(extents[1], -40, -40 * std::sin(40 * pi / 180), length);
}

TEST(TrueExtents, AFlangeAsWideAsTheShaftIsNoDiameter) {
  const Part square = prism({{-40, -40}, {40, -40}, {40, 40}, {-40, 40}}, 5);
  const Part part = together({shaft, moved(square, {0, 0, 40})});
  const auto extents = features::true_extents(world_of(part));
  expect_extent(extents[0], -40, 40, length);
  expect_extent(extents[1], -40, 40, length);
}

// The chamfer of a nut: a cone of 30 degrees, whose hyperbolas have a chord, not a corner, in the middle of each flat.
TEST(TrueExtents, FlatsOfAChamferedHexagonAreNoDiameter) {
  constexpr int chords = 11, count = 6 * chords;
  constexpr double flats = 17, top = 15;
  Part nut;
  std::vector<int> upper, lower;
  for (int i = 0; i < count; ++i) {
    const double angle = pi / 3 * i / chords, from_flat = pi / 3 * (i % chords) / chords - pi / 6;
    const double radius = flats / 2 / std::cos(from_flat);
    const Vec2 way(std::cos(angle), std::sin(angle));
    upper.push_back(nut.add(Vec3(top / 2 * way, 8)));
    nut.add(Vec3(radius * way, 8 - (radius - top / 2) * std::tan(pi / 6)));
    if (i % chords == 0) lower.insert(lower.begin(), nut.add(Vec3(radius * way, 0)));
  }
  nut.faces = {upper, lower};
  for (int i = 0; i < count; ++i) {
    const int a = upper[i], b = upper[(i + 1) % count];
    nut.faces.push_back({a, a + 1, b + 1});
    nut.faces.push_back({a, b + 1, b});
  }
  for (int flat = 0; flat < 6; ++flat) {
    std::vector<int> wall{lower[5 - flat], lower[(10 - flat) % 6]};
    for (int i = chords; i >= 0; --i) wall.push_back(upper[(chords * flat + i) % count] + 1);
    nut.faces.push_back(wall);
  }
  const world::World world = world_of(nut);
  ASSERT_EQ(world.models[0].part->faces.size(), 9u);
  const auto extents = features::true_extents(world);
  expect_extent(extents[0], -flats / std::sqrt(3), flats / std::sqrt(3), length);
  expect_extent(extents[1], -flats / 2, flats / 2, length);
}

TEST(TrueExtents, WithoutFacesVerticesCount) {
  const auto mesh = std::make_shared<const mesh::Mesh>(shaft.mesh());
  const world::World world = world::make_world({{mesh, Mat4(1)}});
  const auto extents = features::true_extents(world);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(extents[axis].from, world.box.min[axis]);
    EXPECT_EQ(extents[axis].to, world.box.max[axis]);
  }
  EXPECT_EQ(world::tessellation_error(world), 0);
}

TEST(TrueExtents, LinesBesideFacesDoNotCount) {
  world::World world = world_of(shaft);
  const auto expected = features::true_extents(world);
  const int first = static_cast<int>(world.points.size());
  for (const Vec3& end : {Vec3(-500, 0, 0), Vec3(500, 600, 70)}) {
    world.points.push_back(end);
    world.box.add(end);
  }
  world.wires = {{first, first + 1}};
  const auto extents = features::true_extents(world);
  for (int axis = 0; axis < 3; ++axis)
    expect_extent(extents[axis], expected[axis].from, expected[axis].to, expected[axis].form);
}

TEST(TessellationError, IsTheHeightOfTheArcOverItsChord) {
  EXPECT_NEAR(world::tessellation_error(world_of(shaft, "scale:2")), 2 * 40 * (1 - std::cos(pi / 26)), 1e-9);
}

}  // namespace
}  // namespace epura::true_extents_test
