// SPDX-License-Identifier: Apache-2.0
// How far around faces go that a file declares, wherever its facets have their vertices.
#include "surfaces/declared_part.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

namespace epura::test::declared_part_test {
namespace {

// A cone from radius 10 to 5 over a height of 12, with a side every 0.3 degrees up to 90 degrees and every 8 from there
// up to `end`.
Part uneven_cone(double end) {
  Part part;
  std::vector<double> degrees;
  for (int i = 0; i < 300; ++i) degrees.push_back(0.3 * i);
  for (double at = 90; at < end - 1e-9; at += 8) degrees.push_back(at);
  if (end < 360) degrees.push_back(end);
  for (const Vec2& ring : {Vec2(10, 0), Vec2(5, 12)})
    for (const double at : degrees)
      part.add({ring.x * std::cos(at * pi / 180), ring.x * std::sin(at * pi / 180), ring.y});
  const int sides = static_cast<int>(degrees.size()), last = end < 360 ? sides - 1 : sides;
  for (int i = 0; i < last; ++i) {
    const int j = (i + 1) % sides;
    part.faces.push_back({i, j, sides + j, sides + i});
  }
  return part;
}

double sweep_of(const Part& part) {
  const mesh::Mesh mesh = part.mesh();
  surfaces::DeclaredPart declared;
  declared.faces = {{surfaces::SurfaceKind::cone, Vec3(0), {0, 0, 1}, 10, 0, -5.0 / 12}};
  declared.face_of_polygon.assign(part.faces.size(), 0);
  const surfaces::PartFaces faces = surfaces::part_of(mesh, declared, 5);
  EXPECT_EQ(faces.faces.size(), 1U);
  return faces.faces.front().sweep;
}

// The largest step is many times the usual one; triangles pass over it, but not over the gap of a part of a cone.
TEST(DeclaredPart, GoesAroundWhereTrianglesDo) {
  EXPECT_EQ(sweep_of(uneven_cone(360)), 360);
  EXPECT_NEAR(sweep_of(uneven_cone(350)), 350, 1e-9);
}

}  // namespace
}  // namespace epura::test::declared_part_test
