// SPDX-License-Identifier: Apache-2.0
// What rounding in a file may tear apart is joined; what is small and genuine stays.
#include "mesh/cracks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test::cracks_test {
namespace {

// Loose triangles: each begins at a given point, and its other corners are far away from all others.
struct Loose {
  mesh::Points points;
  std::vector<int> corners, polygon;

  void add(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c) {
    for (const auto& p : {a, b, c}) {
      corners.push_back(static_cast<int>(points.size()));
      points.push_back(p);
    }
    polygon.push_back(static_cast<int>(polygon.size()));
  }
  void add(std::array<double, 3> a) {
    const double far = 20 * static_cast<double>(polygon.size() + 1);
    add(a, {a[0], a[1] + far, 0}, {a[0], a[1] + far, far});
  }
  [[nodiscard]] mesh::Mending mended(double width, double shortest_part = 0) const {
    const auto table = mesh::make_edge_table(corners, polygon, static_cast<int>(points.size()));
    return mesh::mend_cracks(points, table, {width, Vec3(HUGE_VAL), shortest_part});
  }
};

TEST(Cracks, AreJoinedWithinTheTolerance) {
  Loose triangles;
  triangles.add({0, 0, 0});
  triangles.add({0.9, 0, 0});
  triangles.add({7, 0, 0});
  const mesh::Mending mending = triangles.mended(1);
  EXPECT_EQ(mending.joined, 1);
  EXPECT_EQ(mending.representative.at(3), 0);
  EXPECT_EQ(mending.representative.at(6), 6);
  EXPECT_DOUBLE_EQ(mending.distance, 0.9);
}

// A step of a quarter of a small edge is a part of the model.
TEST(Cracks, BesideSmallEdgesAreNone) {
  Loose triangles;
  triangles.add({0, 0, 0}, {1, 0, 0}, {0.5, -45, 0});
  triangles.add({-0.5, 0, 0});
  EXPECT_TRUE(triangles.mended(1).representative.empty());
  Loose nearer;
  nearer.add({0, 0, 0}, {1, 0, 0}, {0.5, -45, 0});
  nearer.add({-0.2, 0, 0});
  EXPECT_EQ(nearer.mended(1).joined, 1);
}

TEST(Cracks, TakeEdgesAwayThatRoundingMade) {
  Loose triangles;
  triangles.add({10, 0, 0}, {10.4, 0, 0}, {10.5, -45, 0});
  triangles.add({9.5, 0, 0});
  EXPECT_EQ(triangles.mended(1, 0.04).joined, 2);  // 0.4 of 10.4
  EXPECT_TRUE(triangles.mended(1, 0.03).representative.empty());
}

// Rails of a track to the horizon: floats round their distance, not their gauge.
TEST(Cracks, AreNoneAcrossWhatNoCoordinateRounds) {
  const double far = 0x1p30;
  Loose track;
  track.add({-1, far, 0}, {1, far, 0}, {0, 2 * far, 0});
  track.add({-1, far, 0}, {1, far, 0}, {0, 0, 0});
  const mesh::CrackLimits limits = mesh::limits_of_cracks(track.points, track.corners, 0);
  const auto table = mesh::make_edge_table(track.corners, track.polygon, static_cast<int>(track.points.size()));
  const mesh::Mending mending = mesh::mend_cracks(track.points, table, limits);
  EXPECT_EQ(mending.joined, 2);
  EXPECT_NE(mending.representative.at(0), mending.representative.at(1));
}

// From one end of an edge to the other, each step is a crack, but the edge stays.
TEST(Cracks, DoNotTakeAnEdgeAway) {
  Loose triangles;
  triangles.add({0, 0, 0}, {4, 0, 0}, {2, -70, 0});
  for (const double x : {0.9, 1.8, 2.7, 3.5}) triangles.add({x, 0, 0});
  const mesh::Mending mending = triangles.mended(1);
  ASSERT_FALSE(mending.representative.empty());
  EXPECT_NE(mending.representative[0], mending.representative[1]);
  EXPECT_EQ(mending.joined, 4);
}

TEST(Cracks, AreOnlyAtOpenEdges) {
  // Two triangles that share their vertices: the edge between them is not open, its ends are.
  Loose triangles;
  triangles.add({0, 0, 0}, {0, 50, 0}, {40, 25, 0});
  triangles.points.push_back({-40, 25, 0});
  triangles.corners.insert(triangles.corners.end(), {0, 3, 1});
  triangles.polygon.push_back(1);
  EXPECT_TRUE(triangles.mended(1).representative.empty());
}

TEST(Cracks, AreNotBetweenClosedBodies) {
  Loose bodies;
  const auto add_tetrahedron = [&](double x) {
    const auto first = static_cast<int>(bodies.points.size());
    const double away = x > 0 ? 50 : -50;
    for (const auto& p : {std::array{x, 0.0, 0.0}, {x + away, 0, 0}, {x + away, 40, 0}, {x + away, 0, 40}})
      bodies.points.push_back(p);
    for (const auto& face : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}) {
      for (const int corner : face) bodies.corners.push_back(first + corner);
      bodies.polygon.push_back(static_cast<int>(bodies.polygon.size()));
    }
  };
  add_tetrahedron(-0.25);
  add_tetrahedron(0.25);
  EXPECT_TRUE(bodies.mended(1).representative.empty());
}

}  // namespace
}  // namespace epura::test::cracks_test
