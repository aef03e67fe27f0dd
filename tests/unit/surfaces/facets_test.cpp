// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: bores at whose rims other edges end, which would fall apart.
#include "surfaces/facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "shapes.hpp"
#include "surfaces/recognise.hpp"

namespace epura::facets_test {
namespace {

using namespace test;

// Adds a vertex to the side of all polygons that have it.
void divide_side(Part& part, int a, int b, double at) {
  const int middle = part.add(part.points[std::size_t(a)] * (1 - at) + part.points[std::size_t(b)] * at);
  for (auto& face : part.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int next = face[(i + 1) % face.size()];
      if ((face[i] != a || next != b) && (face[i] != b || next != a)) continue;
      face.insert(face.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
      break;
    }
}

// Where an edge of another face ends at a rim, meshers divide the chord there, below the surface.
TEST(Facets, VerticesInsideChordsAreNoPlacesOfASurface) {
  for (const double at : {0.08, 0.5}) {
    Part part = revolved({{0, 0}, {5, 0}, {5, 8}, {0, 8}}, 36);
    // After the pole of the lower face.
    for (const int first : {3, 20}) {
      divide_side(part, 1 + first, 1 + first + 1, at);
      divide_side(part, 37 + first, 37 + first + 1, at);
    }
    const surfaces::PartFaces found = surfaces::recognise_faces(part.mesh());
    ASSERT_EQ(found.faces.size(), 3U) << at;
    const surfaces::PartFace& face = only(found, surfaces::SurfaceKind::cylinder);
    EXPECT_NEAR(face.surface.radius, 5, 1e-12);
    EXPECT_EQ(face.sweep, 360);
    EXPECT_EQ(found.borders.size(), 2U);
  }
  // A vertex beside the chord is none inside it.
  Part part = revolved({{0, 0}, {5, 0}, {5, 8}, {0, 8}}, 36);
  divide_side(part, 4, 5, 0.5);
  part.points.back() *= 0.99;
  EXPECT_GT(surfaces::recognise_faces(part.mesh()).faces.size(), 3U);
}

TEST(Facets, AreTheSameWhicheverCornerOfATriangleComesFirst) {
  Part part = revolved({{0, 0}, {5, 0}, {5, 8}, {0, 9}}, 12);
  part.triangulate();
  const surfaces::Facets facets = surfaces::make_facets(part.mesh());
  for (const int turn : {1, 2}) {
    Part other = part;
    for (auto& face : other.faces) std::rotate(face.begin(), face.begin() + turn, face.end());
    const surfaces::Facets found = surfaces::make_facets(other.mesh());
    EXPECT_EQ(found.corners, facets.corners);
    ASSERT_EQ(found.normals.size(), facets.normals.size());
    for (std::size_t t = 0; t < found.normals.size(); ++t) EXPECT_EQ(found.normals[t], facets.normals[t]) << t;
  }
}

}  // namespace
}  // namespace epura::facets_test
