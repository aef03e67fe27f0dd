// SPDX-License-Identifier: Apache-2.0
// Surfaces of revolution near those that have a name: cones that are nearly cylinders, and curves that are no lines.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shapes.hpp"
#include "surfaces/recognise.hpp"

namespace epura::revolution_test {
namespace {

using namespace test;

surfaces::PartFaces recognise(const Part& part) { return surfaces::recognise_faces(part.mesh()); }

TEST(SurfacesOfRevolution, ASlenderConeIsOneFace) {
  // Along a quarter of the cone, a cylinder lies within tolerance.
  for (const double degrees : {0.1, 0.01, 0.004, 0.003, 0.002, 0.001, 0.0007, 0.0005}) {
    const double slope = std::tan(degrees * pi / 180);
    const surfaces::PartFaces part = recognise(revolved({{0, 0}, {10, 0}, {10 - 20 * slope, 20}, {0, 20}}, 48));
    ASSERT_EQ(part.faces.size(), 3U) << degrees;
    const surfaces::PartFace& face = only(part, surfaces::SurfaceKind::cone);
    EXPECT_NEAR(std::abs(face.surface.slope), slope, 1e-12) << degrees;
  }
  // Below tolerance, it is a cylinder.
  const surfaces::PartFaces pin = recognise(revolved({{0, 0}, {10, 0}, {10 - 1e-6, 20}, {0, 20}}, 48));
  EXPECT_NEAR(only(pin, surfaces::SurfaceKind::cylinder).surface.radius, 10, 1e-6);
}

TEST(SurfacesOfRevolution, ASurfaceOfRevolutionOverACurveIsNoStackOfCones) {
  // A baluster on a foot; its profile turns back three times.
  std::vector<Vec2> profile{{0, -30}, {15, -30}, {15, 0}};
  for (int i = 0; i <= 40; ++i) profile.emplace_back(8 + 2 * std::sin(0.3 * i) + 0.05 * i, 1.0 * i);
  profile.emplace_back(0, 40);
  const surfaces::PartFaces part = recognise(revolved(profile, 48));
  EXPECT_EQ(count(part, surfaces::SurfaceKind::cone), 0);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::cylinder), 1);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::free_form), 1);
  EXPECT_EQ(part.faces.size(), 5U);
}

// Two circles about one axis lie on a sphere: the staggered triangles between them, too, which no cone has.
TEST(SurfacesOfRevolution, AStripOfStaggeredTrianglesIsNoSphere) {
  std::vector<Vec2> profile{{0, -30}, {25, -30}, {25, 0}};
  for (int i = 1; i <= 24; ++i) profile.emplace_back(25 - 0.02 * i * i - 0.1 * std::sin(0.7 * i), 1.0 * i);
  profile.emplace_back(0, 24);
  Part part = revolved(profile, 48);
  part.triangulate().move([&](const Vec3& p) {
    const int ring = static_cast<int>(std::lround(p.z));
    const double angle = p.z > 0 && p.z < 24 && ring % 2 != 0 ? pi / 48 : 0;
    return Vec3(p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle), p.z);
  });
  const surfaces::PartFaces found = recognise(part);
  EXPECT_EQ(count(found, surfaces::SurfaceKind::sphere), 0);
  EXPECT_EQ(count(found, surfaces::SurfaceKind::cylinder), 1);
}

// Meshers crowd vertices around an apex, off the cone by rounding: facets that reach there face anywhere.
TEST(SurfacesOfRevolution, AConeWithACrowdedApexIsOneFace) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> around(-1, 1);
    Part part =
        revolved({{0, 0}, {500, 0}, {0.6, 800 - 0.96}, {0.003, 800 - 0.0048}, {0.0015, 800 - 0.0024}, {0, 800}}, 48);
    part.triangulate().move([&](const Vec3& p) {
      const bool at_apex = p.z > 799.9;
      return at_apex ? p + 0.0004 * Vec3(around(random), around(random), around(random)) : p;
    });
    const surfaces::PartFaces found = recognise(part.round_to_float());
    EXPECT_EQ(found.faces.size(), 2U) << seed;
    EXPECT_EQ(count(found, surfaces::SurfaceKind::cone), 1) << seed;
  }
}

}  // namespace
}  // namespace epura::revolution_test
