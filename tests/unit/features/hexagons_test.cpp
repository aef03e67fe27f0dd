// SPDX-License-Identifier: Apache-2.0
// Hexagons among plane faces, and what is none.
#include "features/hexagons.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace epura::test::hexagons_test {
namespace {

using Faces = std::vector<features::PlaneFace>;

constexpr double degree = std::numbers::pi / 180;

// The sides of a regular prism of height 10 along z around (30, 20), from one part of their width to another one.
Faces prism(int sides, double across_flats, double turned = 0, double from = -1, double to = 1) {
  Faces faces;
  for (int i = 0; i < sides; ++i) {
    const double angle = (turned + 360.0 * i / sides) * degree;
    const Vec3 out(std::cos(angle), std::sin(angle), 0), aside(-out.y, out.x, 0), foot(30, 20, 0);
    const double half = across_flats / 2, width = half * std::tan(std::numbers::pi / sides);
    features::PlaneFace face{0, out, {}};
    for (const double z : {0.0, 10.0})
      for (const double at : {from, to}) face.corners.push_back(foot + half * out + at * width * aside + Vec3(0, 0, z));
    faces.push_back(face);
  }
  return faces;
}

Faces changed(Faces faces, const std::function<void(features::PlaneFace&)>& change) {
  for (features::PlaneFace& face : faces) change(face);
  return faces;
}

TEST(Hexagons, HaveTheirWidthAndAxis) {
  for (const double turned : {0.0, 11.0, 30.0, 45.0}) {
    const auto found = features::find_hexagons(3, prism(6, 17, turned));
    ASSERT_EQ(found.size(), 1U) << turned;
    EXPECT_EQ(found[0].model, 3);
    EXPECT_NEAR(found[0].across_flats, 17, 1e-9);
    EXPECT_NEAR(glm::distance(found[0].centre, Vec3(30, 20, 5)), 0, 1e-9);
    EXPECT_NEAR(found[0].half_height, 5, 1e-9);
    EXPECT_FALSE(found[0].inwards);
    EXPECT_NEAR(found[0].reach(found[0].normals[0]), 8.5, 1e-9) << "across flats";
    const double corner = (turned + 30) * degree;
    EXPECT_NEAR(found[0].reach(Vec3(std::cos(corner), std::sin(corner), 0)), 17 / std::sqrt(3.0), 1e-9);
  }
}

TEST(Hexagons, OfSocketsLookInwards) {
  const auto found =
      features::find_hexagons(0, changed(prism(6, 8), [](features::PlaneFace& face) { face.normal = -face.normal; }));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].inwards);
  EXPECT_NEAR(found[0].across_flats, 8, 1e-9);
}

// A slot along x divides two flats; those of a castle nut are parts of their sides at its end.
TEST(Hexagons, MayBeSlotted) {
  Faces left = prism(6, 17, 0, -1, -0.2), right = prism(6, 17, 0, 0.2, 1);
  left.insert(left.end(), right.begin(), right.end());
  const auto found = features::find_hexagons(0, left);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].across_flats, 17, 1e-9);
}

TEST(Hexagons, AreRegularAndWhole) {
  const auto count = [](const Faces& faces) { return features::find_hexagons(0, faces).size(); };
  EXPECT_EQ(count(prism(12, 17)), 0U) << "every second side of a prism of twelve";
  EXPECT_EQ(count(prism(8, 17)), 0U);
  EXPECT_EQ(count(prism(6, 17, 0, -0.5, 0.5)), 0U) << "much of the corners is missing";
  EXPECT_EQ(count(changed(prism(6, 17),
                          [](features::PlaneFace& face) {
                            for (Vec3& p : face.corners) p.x *= 1.01;
                            face.normal = glm::normalize(Vec3(face.normal.x / 1.01, face.normal.y, 0));
                          })),
            0U)
      << "stretched";
  Faces five = prism(6, 17);
  five.pop_back();
  EXPECT_EQ(count(five), 0U);
  Faces apart = prism(6, 17);
  apart.back().body = 1;
  EXPECT_EQ(count(apart), 0U) << "of two bodies";
}

TEST(Hexagons, InOnePlaceAreOne) {
  Faces faces = prism(6, 17), above = prism(6, 19), beside = prism(6, 17);
  for (features::PlaneFace& face : above)
    for (Vec3& p : face.corners) p.z += 10;
  for (features::PlaneFace& face : beside)
    for (Vec3& p : face.corners) p.x += 40;
  faces.insert(faces.end(), above.begin(), above.end());
  faces.insert(faces.end(), beside.begin(), beside.end());
  EXPECT_EQ(features::find_hexagons(0, faces).size(), 3U);
}

}  // namespace
}  // namespace epura::test::hexagons_test
