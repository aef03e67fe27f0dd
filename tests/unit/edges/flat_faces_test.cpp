// SPDX-License-Identifier: Apache-2.0
#include "edges/flat_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "edges/crossing_candidates.hpp"
#include "edges/intersections.hpp"
#include "shapes.hpp"

namespace epura::test::flat_faces_test {
namespace {

constexpr double contact = 1e-9;

// `blades` triangles round one hub at the given height over their rim.
Shape disk(int blades, double hub_height, double lean = 0) {
  Shape shape{{{0, 0, hub_height}}, {}, {}};
  for (int i = 0; i < blades; ++i) {
    const double angle = 2 * M_PI * i / blades;
    shape.points.push_back({std::cos(angle), std::sin(angle), lean * std::cos(angle)});
    shape.faces.push_back({0, 1 + i, 1 + (i + 1) % blades});
  }
  return shape;
}

std::vector<int> faces_of(const world::World& world) {
  return edges::flat_faces(world, edges::normalised_points(world, 1), contact, edges::all_triangles(world).triangles);
}

TEST(FlatFaces, AreFoundAmongTrianglesRoundOneHub) {
  for (const double lean : {0.0, 0.3}) {
    const std::vector<int> faces = faces_of(world_of(disk(1000, 0, lean)));
    EXPECT_EQ(faces, std::vector<int>(1000, 0)) << lean;
  }
}

// The plane of a needle is uncertain; that of all of them is not.
TEST(FlatFaces, AreFoundWherePointsAreRounded) {
  Shape shape = disk(1000, 0, 0.3);
  for (std::size_t i = 0; i < shape.points.size(); ++i)
    shape.points[i][2] += 0.4 * contact * std::sin(7.0 * static_cast<double>(i));
  EXPECT_EQ(faces_of(world_of(shape)), std::vector<int>(1000, 0));
}

TEST(FlatFaces, AreNoCones) { EXPECT_TRUE(faces_of(world_of(disk(1000, 0.1))).empty()); }

// Neighbours lie in one plane, as far as contact tells; the strip as a whole does not.
TEST(FlatFaces, AreNotGentlyCurved) {
  const auto strip = [](double bend) {
    Shape shape;
    for (int i = 0; i <= 400; ++i)
      for (const double y : {0.0, 0.01}) shape.points.push_back({i / 400.0, y, bend * i * i / 160000.0});
    for (int i = 0; i < 400; ++i) shape.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    return shape;
  };
  EXPECT_EQ(faces_of(world_of(strip(0))), std::vector<int>(800, 0));
  EXPECT_TRUE(faces_of(world_of(strip(1e-4))).empty());
}

TEST(FlatFaces, AreNotFoundWhereFew) { EXPECT_TRUE(faces_of(world_of(disk(100, 0))).empty()); }

TEST(FlatFaces, OfTwoPlanesAreTwo) {
  Shape shape = disk(300, 0);
  shape.add(disk(400, 0, 0.5).moved(5, 0, 0));
  const std::vector<int> faces = faces_of(world_of(shape));
  ASSERT_EQ(faces.size(), 700U);
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 0), 300);
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 1), 400);
}

TEST(FlatFaces, OfSomeOfTheTrianglesHaveTheirPlaces) {
  const world::World world = world_of(disk(1000, 0));
  std::vector<int> some(500);
  std::iota(some.begin(), some.end(), 300);
  EXPECT_EQ(edges::flat_faces(world, edges::normalised_points(world, 1), contact, some), std::vector<int>(500, 0));
}

}  // namespace
}  // namespace epura::test::flat_faces_test
