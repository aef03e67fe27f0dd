// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: radii and axes of everything that is recognised.
#include "surfaces/part_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "surfaces/estimates.hpp"
#include "surfaces/region.hpp"

namespace epura::part_surface_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Points by two numbers between 0 and 1.
template <class Place>
std::vector<Vec3> points_of(const Place& place, int count = 40) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(place(part(random), part(random)));
  return points;
}

const Vec3 axis = glm::normalize(Vec3(0.3, -0.5, 0.8)), centre(0.2, 0.1, -0.3);
const Vec3 across = glm::normalize(glm::cross(axis, Vec3(1, 0, 0))), upwards = glm::cross(axis, across);

Vec3 around(double angle) { return std::cos(angle) * across + std::sin(angle) * upwards; }

surfaces::PartSurface disturbed(surfaces::PartSurface surface) {
  surface.origin += Vec3(0.02, -0.01, 0.015);
  if (surface.axis != Vec3(0)) surface.axis = glm::normalize(surface.axis + Vec3(0.03, 0.02, -0.02));
  surface.radius *= 1.05;
  surface.minor *= 0.93;
  surface.slope *= 1.1;
  return surface;
}

void expect_axis(const surfaces::PartSurface& surface) {
  EXPECT_GT(std::abs(glm::dot(surface.axis, axis)), 1 - 1e-14);
  const Vec3 from = surface.origin - centre;
  EXPECT_LT(glm::length(from - glm::dot(from, axis) * axis), 1e-12);
}

TEST(PartSurface, FitFindsACylinder) {
  const auto points = points_of([](double u, double v) { return centre + 0.4 * around(2 * u) + (v - 0.5) * axis; });
  surfaces::PartSurface surface = disturbed({surfaces::SurfaceKind::cylinder, centre, axis, 0.4});
  EXPECT_LT(surfaces::refine(surface, points), 1e-13);
  EXPECT_NEAR(surface.radius, 0.4, 1e-13);
  expect_axis(surface);
}

TEST(PartSurface, FitFindsACone) {
  const auto points =
      points_of([](double u, double v) { return centre + (0.4 + 0.5 * (v - 0.5)) * around(3 * u) + (v - 0.5) * axis; });
  surfaces::PartSurface surface = disturbed({surfaces::SurfaceKind::cone, centre, axis, 0.4, 0, 0.5});
  EXPECT_LT(surfaces::refine(surface, points), 1e-13);
  EXPECT_NEAR(surface.slope, 0.5, 1e-12);
  EXPECT_NEAR(surface.radius, 0.4 + 0.5 * glm::dot(surface.origin - centre, surface.axis), 1e-12);
  expect_axis(surface);
}

TEST(PartSurface, FitFindsASphereFromNothing) {
  const auto points =
      points_of([](double u, double v) { return centre + 0.6 * (std::cos(v) * around(u) + std::sin(v) * axis); });
  auto surface = surfaces::begin_sphere(points);
  ASSERT_TRUE(surface);
  EXPECT_LT(surfaces::refine(*surface, points), 1e-13);
  EXPECT_NEAR(surface->radius, 0.6, 1e-12);
  EXPECT_LT(glm::distance(surface->origin, centre), 1e-12);
}

TEST(PartSurface, FitFindsATorus) {
  const auto points = points_of([](double u, double v) {
    return centre + (0.4 + 0.1 * std::cos(2 * v)) * around(2 * u) + 0.1 * std::sin(2 * v) * axis;
  });
  surfaces::PartSurface surface = disturbed({surfaces::SurfaceKind::torus, centre, axis, 0.4, 0.1});
  EXPECT_LT(surfaces::refine(surface, points), 1e-13);
  EXPECT_NEAR(surface.radius, 0.4, 1e-12);
  EXPECT_NEAR(surface.minor, 0.1, 1e-12);
  expect_axis(surface);
}

// Radii grow in the direction into which the axis turns by the same step. The points are those of a coarse fillet
// around a hub, four columns of ten.
TEST(PartSurface, FitFindsATorusFromATiltedOne) {
  constexpr double radius = 0.31, minor = 0.0124;
  std::vector<Vec3> points;
  for (int i = -1; i <= 2; ++i)
    for (int j = 0; j < 10; ++j) {
      const double v = pi + j * pi / 18;
      points.push_back(centre + (radius + minor * std::cos(v)) * around(0.1 * i) + minor * std::sin(v) * axis);
    }
  const Vec3 tilted = glm::normalize(axis + 0.14 * across + 0.01 * upwards);
  const Vec3 outwards = glm::normalize(across - glm::dot(across, tilted) * tilted);
  const Vec3 hub = centre + radius * across - 0.92 * radius * outwards;
  surfaces::PartSurface surface{surfaces::SurfaceKind::torus, hub, tilted, 0.92 * radius, minor};
  EXPECT_LT(surfaces::refine(surface, points), 1e-13);
  EXPECT_NEAR(surface.radius, radius, 1e-11);
}

TEST(PartSurface, DistancesAndNormalsAgree) {
  const std::vector<surfaces::PartSurface> surfaces{{surfaces::SurfaceKind::plane, centre, axis},
                                                    {surfaces::SurfaceKind::cylinder, centre, axis, 0.4},
                                                    {surfaces::SurfaceKind::cone, centre, axis, 0.4, 0, 0.7},
                                                    {surfaces::SurfaceKind::sphere, centre, Vec3(0), 0.4},
                                                    {surfaces::SurfaceKind::torus, centre, axis, 0.5, 0.2}};
  for (const surfaces::PartSurface& surface : surfaces)
    for (const Vec3& p : points_of([](double u, double v) { return centre + 0.45 * around(6 * u) + 0.1 * v * axis; })) {
      const double distance = surfaces::signed_distance(surface, p);
      const Vec3 normal = surfaces::normal_near(surface, p);
      EXPECT_NEAR(glm::length(normal), 1, 1e-12);
      // Along the normal the distance shrinks by what one goes.
      EXPECT_NEAR(surfaces::signed_distance(surface, p - distance * normal), 0, 1e-12) << int(surface.kind);
    }
}

TEST(PartSurface, TheMiddleOfATorusIsFarFromIt) {
  const surfaces::PartSurface torus{surfaces::SurfaceKind::torus, centre, axis, 0.5, 0.2};
  EXPECT_NEAR(surfaces::signed_distance(torus, centre), 0.5 - 0.2, 1e-12);
  EXPECT_NEAR(surfaces::signed_distance(torus, centre + 1.2 * axis), 1.3 - 0.2, 1e-12);
}

TEST(PartSurface, TwoWaysBeginATorus) {
  constexpr double step = pi / 20;
  std::vector<surfaces::Facing> facings;
  std::vector<Vec3> points;
  const auto at = [&](double u, double v) {
    return centre + (0.5 + 0.2 * std::cos(v)) * around(u) + 0.2 * std::sin(v) * axis;
  };
  for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
    const double u = 0.4 + i * step, v = 0.7 + j * step;
    const std::array<Vec3, 4> c{at(u, v), at(u + step, v), at(u + step, v + step), at(u, v + step)};
    points.insert(points.end(), c.begin(), c.end());
    facings.push_back({(c[0] + c[1] + c[2] + c[3]) / 4.0, glm::normalize(glm::cross(c[2] - c[0], c[3] - c[1])), 1});
  }
  const auto curvatures = surfaces::curvatures_of(facings.front(), points);
  ASSERT_TRUE(curvatures);
  for (auto begun :
       {surfaces::begin_torus_by_normals(facings, points), surfaces::begin_torus_by_curvatures(*curvatures, points)}) {
    ASSERT_TRUE(begun);
    EXPECT_LT(surfaces::refine(*begun, points), 1e-12);
    EXPECT_NEAR(begun->radius, 0.5, 1e-10);
    EXPECT_NEAR(begun->minor, 0.2, 1e-10);
  }
}

TEST(PartSurface, CurvaturesBeginACone) {
  std::vector<Vec3> points;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      const double v = 0.05 * j + 0.01 * i;
      points.push_back(centre + (0.5 + 0.6 * v) * around(0.4 + 0.1 * i) + v * axis);
    }
  const Vec3 normal = glm::normalize(around(0.4) - 0.6 * axis);
  const auto curvatures = surfaces::curvatures_of({centre + 0.5 * around(0.4), normal, 1}, points);
  ASSERT_TRUE(curvatures);
  auto begun = surfaces::begin_cone_by_curvatures(*curvatures, points);
  ASSERT_TRUE(begun);
  EXPECT_LT(surfaces::refine(*begun, points), 1e-12);
  EXPECT_NEAR(std::abs(begun->slope), 0.6, 1e-9);
  expect_axis(*begun);
}

// Cones that differ little near few points form a bent valley of the sum of squares, along which a fit must go to the
// end. The points are those around a facet of a countersink of a mesh without strips.
TEST(PartSurface, FitFindsAConeThroughAFewPoints) {
  for (const double size : {0.1, 0.15, 0.2}) {
    std::vector<Vec3> points;
    for (int row = -2; row <= 1; ++row)
      for (int i = -1; i <= 1; ++i) {
        const double u = size * (i + 0.5 * (row % 2) + 0.1 * row), v = 0.8 * size * (row + 0.1 * i);
        points.push_back(centre + (0.5 + v) * around(u) + v * axis);
      }
    const auto curvatures =
        surfaces::curvatures_of({centre + 0.5 * around(0), glm::normalize(around(0) - axis), 1}, points);
    ASSERT_TRUE(curvatures);
    auto begun = surfaces::begin_cone_by_curvatures(*curvatures, points);
    ASSERT_TRUE(begun);
    EXPECT_LT(surfaces::refine(*begun, points), 1e-12) << size;
    EXPECT_NEAR(std::abs(begun->slope), 1, 1e-8) << size;
  }
}

TEST(PartSurface, GivesUpWhereNothingFits) {
  const auto points = points_of([](double u, double v) { return Vec3(u, v, std::sin(9 * u) * std::cos(7 * v)); });
  surfaces::PartSurface surface{surfaces::SurfaceKind::cylinder, Vec3(0), Vec3(0, 0, 1), 1};
  EXPECT_GT(surfaces::refine(surface, points, 1e-6), 0.01);
}

// A file may declare a cone by its apex.
TEST(Cones, GoAroundFromTheirApex) {
  surfaces::PartSurface cone;
  cone.kind = surfaces::SurfaceKind::cone;
  cone.origin = centre;
  cone.axis = axis;
  cone.slope = 1.66;
  std::vector<Vec3> points{centre};
  for (int i = 0; i < 36; ++i)
    points.push_back(centre + 6.0 * axis + 9.96 * (std::cos(i * pi / 18) * across + std::sin(i * pi / 18) * upwards));
  for (const double radius : {0.0, 1e-9}) {
    cone.radius = radius;
    for (const double allowance : {0.0, 1e-13}) {
      const surfaces::Reach reach = surfaces::reach_of(cone, points, allowance);
      EXPECT_EQ(reach.sweep, 360);
      EXPECT_NEAR(reach.from, 0, 1e-12);
      EXPECT_NEAR(reach.to, 6, 1e-12);
    }
  }
  points.resize(19);
  EXPECT_NEAR(surfaces::reach_of(cone, points, 1e-13).sweep, 170, 1e-9);
}

}  // namespace
}  // namespace epura::part_surface_test
