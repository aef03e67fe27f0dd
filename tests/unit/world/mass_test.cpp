// SPDX-License-Identifier: Apache-2.0
// Volumes and centres of gravity against closed forms.
#include "world/mass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scene/transform.hpp"
#include "shapes.hpp"

namespace epura::test::mass_test {
namespace {

std::vector<world::Solid> solids(const Shape& shape, const std::string& steps = "scale:1") {
  return world::solids_of(mesh_of(shape), scene::parse_transform(steps));
}

// Corners at the origin and on the axes.
Shape tetrahedron(double x, double y, double z) {
  Shape shape;
  shape.points = {{0, 0, 0}, {x, 0, 0}, {0, y, 0}, {0, 0, z}};
  shape.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return shape;
}

void expect_at(const Vec3& a, const Vec3& b) { EXPECT_LT(glm::length(a - b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(Mass, OfBodiesWithAFaceInCommon) {
  Shape both = box({0, 0, 0}, {2, 2, 2});
  both.add(box({2, 0, 0}, {5, 2, 2}));
  const auto two = solids(both);
  ASSERT_EQ(two.size(), 2U);
  for (const world::Solid& one : two) EXPECT_EQ(one.fault, "");
  EXPECT_NEAR(std::min(two[0].volume, two[1].volume), 8, 1e-12);
  EXPECT_NEAR(std::max(two[0].volume, two[1].volume), 12, 1e-12);
}

TEST(Mass, OfATetrahedronIsASixthOfItsBox) {
  const auto one = solids(tetrahedron(3, 4, 5));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].fault, "");
  EXPECT_NEAR(one[0].volume, 10, 1e-12);
  EXPECT_NEAR(one[0].area, 6 + 7.5 + 10 + std::sqrt(12.0 * 12 + 15 * 15 + 20 * 20) / 2, 1e-12);
  expect_at(one[0].centre, {0.75, 1, 1.25});
}

TEST(Mass, DoesNotDependOnPlaceTurnOrMirror) {
  for (const char* steps : {"translate:1e6,-2e6,3e6", "rotate:x,31 rotate:z,-77", "scale:-1"}) {
    const auto one = solids(tetrahedron(3, 4, 5), steps);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].fault, "") << steps;
    EXPECT_NEAR(one[0].volume, 10, 1e-7) << steps;
    EXPECT_LT(glm::length(one[0].centre - Vec3(scene::parse_transform(steps) * Vec4(0.75, 1, 1.25, 1))), 1e-7) << steps;
  }
}

// A cube of side 3 with one of side 1 in its middle.
TEST(Mass, LeavesOutCavities) {
  const auto hollow = solids(cube_with_a_cavity(true));
  ASSERT_EQ(hollow.size(), 1U);
  EXPECT_EQ(hollow[0].fault, "");
  EXPECT_NEAR(hollow[0].volume, 26, 1e-12);
  EXPECT_NEAR(hollow[0].area, 60, 1e-12);
  expect_at(hollow[0].centre, {1.5, 1.5, 1.5});
}

// As where a mirrored copy was exported without turning its faces.
TEST(Mass, OfABodyTurnedInsideOutIsThatOfTheBodyTurnedBack) {
  Shape two = box({0, 0, 0}, {3, 2, 2});
  Shape mirrored = box({5, 0, 0}, {6, 2, 2});
  for (auto& face : mirrored.faces) std::reverse(face.begin(), face.end());
  two.add(mirrored);
  const auto found = solids(two);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].fault, "");
  EXPECT_NEAR(found[1].volume, 4, 1e-12);
  expect_at(found[1].centre, {5.5, 1, 1});
  EXPECT_TRUE(found[1].turned);
  EXPECT_FALSE(found[0].turned);
}

Shape inside_out(Shape shape) {
  for (auto& face : shape.faces) std::reverse(face.begin(), face.end());
  return shape;
}

// A square ring around the z axis, and a pin in its hole, within the box of the ring.
std::vector<world::Solid> ring_and_pin(bool turn_ring, bool turn_pin, double side, const std::string& steps) {
  Shape ring;
  for (const double z : {0.0, 4.0})
    for (const double r : {10.0, 3.0})
      for (const Vec2 at : {Vec2(-r, -r), Vec2(r, -r), Vec2(r, r), Vec2(-r, r)}) ring.points.push_back({at.x, at.y, z});
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    ring.faces.insert(
        ring.faces.end(),
        {{i, j, j + 8, i + 8}, {i + 4, i + 12, j + 12, j + 4}, {i + 8, j + 8, j + 12, i + 12}, {i, i + 4, j + 4, j}});
  }
  const Shape pin = box({-side, -side, 1}, {side, side, 3});
  Shape both = turn_ring ? inside_out(ring) : ring;
  both.add(turn_pin ? inside_out(pin) : pin);
  return solids(both, steps);
}

// A shell in the hole of another one is no cavity of it, whichever of the two is turned inside out.
TEST(Mass, OfABodyInAHoleIsItsOwn) {
  for (const char* steps : {"scale:1", "scale:1,1,-1"})
    for (const bool turn_ring : {false, true})
      for (const bool turn_pin : {false, true}) {
        const auto found = ring_and_pin(turn_ring, turn_pin, 2.5, steps);
        ASSERT_EQ(found.size(), 2U) << steps << turn_ring << turn_pin;
        EXPECT_NEAR(found[0].volume, 4 * (400 - 36), 1e-9);
        EXPECT_NEAR(found[1].volume, 50, 1e-9);
        EXPECT_EQ(found[0].turned, turn_ring && !turn_pin) << steps;
        EXPECT_EQ(found[1].turned, turn_pin && !turn_ring) << steps;
      }
}

TEST(Mass, OfABodyThatTouchesTheWallsOfAHoleIsItsOwn) {
  const auto found = ring_and_pin(false, true, 3, "scale:1");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[1].volume, 72, 1e-9);
}

TEST(Mass, LeavesOutCavitiesOfWhatIsInsideOut) {
  Shape all = inside_out(cube_with_a_cavity(true));
  all.add(box({10, 0, 0}, {11, 1, 1}));
  const auto found = solids(all);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].volume, 26, 1e-12);
  expect_at(found[0].centre, {1.5, 1.5, 1.5});
  EXPECT_TRUE(found[0].turned);
  EXPECT_FALSE(found[1].turned);
}

// As where a program writes a part and its mirrored copy under one name.
TEST(Mass, OfANamedBodyIsThatOfAllItsShells) {
  Shape all = box({0, 0, 0}, {3, 2, 2});
  all.add(inside_out(box({5, 0, 0}, {8, 2, 2})));
  all.add(cube_with_a_cavity(true).moved(20, 0, 0));
  mesh::Mesh mesh = mesh_of(all);
  std::fill(mesh.body.begin(), mesh.body.end(), 0);
  const auto found = world::solids_of(mesh, scene::parse_transform("scale:1"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].volume, 12 + 12 + 26, 1e-12);
  EXPECT_TRUE(found[0].turned);
}

TEST(Mass, OfWhatIsNotClosedIsRefused) {
  Shape open = tetrahedron(1, 1, 1);
  open.faces.pop_back();
  EXPECT_EQ(solids(open).at(0).fault, "it has 3 open edges");
  Shape turned = tetrahedron(1, 1, 1);
  std::swap(turned.faces[0][0], turned.faces[0][1]);
  EXPECT_EQ(solids(turned).at(0).fault, "it has 3 edges between faces that are turned to different sides");
}

TEST(Mass, OfSeveralBodiesWeighsTheirDensities) {
  const std::vector<world::Solid> two{{0, "", 10, 1, {0, 0, 0}}, {1, "", 30, 2, {4, 0, 0}}};
  const std::vector<double> none{0, 7850}, both{3000, 1000};
  const world::MassProperties volume = world::sum_of(two, none), mass = world::sum_of(two, both);
  EXPECT_FALSE(volume.mass);
  EXPECT_NEAR(volume.centre.x, 3, 1e-12);
  EXPECT_NEAR(*mass.mass, 60e-6, 1e-18);
  EXPECT_NEAR(mass.centre.x, 2, 1e-12);
}

}  // namespace
}  // namespace epura::test::mass_test
