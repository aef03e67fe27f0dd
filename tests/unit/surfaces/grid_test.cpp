// SPDX-License-Identifier: Apache-2.0
// Parts whose vertices were moved to the points of a grid: few decimals, or the integers of a quantised mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "shapes.hpp"
#include "surfaces/recognise.hpp"

namespace epura::test::grid_test {
namespace {

// A disc with a bore, not at the origin of the grid, whose step is `step` in every axis.
Part disc_on_grid(int segments, double step, double bore = 5) {
  Part disc = revolved({{bore, 0}, {20, 0}, {20, 6}, {bore, 6}, {bore, 0}}, segments).triangulate();
  disc.is_printed = true;
  return disc.move([step](const Vec3& p) {
    const Vec3 from(3.7, -2.3, 0);
    return from + step * glm::round((p - from) / step);
  });
}

// Of decimals, and of the lattices to which programs for the web round by default.
TEST(Grid, HasBores) {
  for (const double step : {0.01, 0.001, 40 / 16383.0, 40 / 4095.0})
    for (const int segments : {24, 32, 64}) {
      if (5 * (1 - std::cos(pi / segments)) < step) continue;  // the grid is coarser than the facets
      const auto part = surfaces::recognise_faces(disc_on_grid(segments, step).mesh());
      std::vector<double> radii;
      for (const surfaces::PartFace& face : part.faces)
        if (face.surface.kind == surfaces::SurfaceKind::cylinder) radii.push_back(face.surface.radius);
      std::sort(radii.begin(), radii.end());
      ASSERT_EQ(radii.size(), 2u) << step << ' ' << segments;
      EXPECT_NEAR(radii[0], 5, step) << step << ' ' << segments;
      EXPECT_NEAR(radii[1], 20, step) << step << ' ' << segments;
    }
}

// Facets of 2.8 degrees rise 0.0009 over a bore of this radius, hardly more than the grid moves their vertices.
TEST(Grid, HasBoresWhoseFacetsRiseByAStep) {
  const auto part = surfaces::recognise_faces(disc_on_grid(128, 0.001, 3).mesh());
  EXPECT_TRUE(std::ranges::any_of(part.faces, [](const surfaces::PartFace& face) {
    return face.surface.kind == surfaces::SurfaceKind::cylinder && std::abs(face.surface.radius - 3) < 0.001;
  }));
}

// Vertices leave a slanted plane by half the diagonal of a cell of the grid, at most.
TEST(Grid, HasSlantedPlanes) {
  const Vec3 axis = glm::normalize(Vec3(0.31, 0.47, 1)), u = glm::normalize(glm::cross(axis, Vec3(1, 0, 0))),
             v = glm::cross(axis, u);
  for (const double step : {0.01, 0.001, 0.0001}) {
    Part disc = revolved({{5, 0}, {20, 0}, {20, 6}, {5, 6}, {5, 0}}, 32).triangulate();
    disc.is_printed = true;
    disc.move([&](const Vec3& p) { return step * glm::round((p.x * u + p.y * v + p.z * axis) / step); });
    EXPECT_EQ(surfaces::recognise_faces(disc.mesh()).faces.size(), 4u) << step;
  }
}

}  // namespace
}  // namespace epura::test::grid_test
