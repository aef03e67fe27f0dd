// SPDX-License-Identifier: Apache-2.0
#include "mesh/triangulate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/vec.hpp"

namespace epura::test::triangulate_test {
namespace {

using Polygon = std::vector<std::array<double, 2>>;

mesh::Triangulation triangulated(const Polygon& polygon, const mesh::Points& points) {
  mesh::Faces faces;
  faces.corners.resize(polygon.size());
  std::iota(faces.corners.begin(), faces.corners.end(), 0);
  faces.ends = {static_cast<int>(polygon.size())};
  faces.number = {7};
  return mesh::triangulate(faces, points);
}

mesh::Points in_a_plane(const Polygon& polygon) {
  mesh::Points points;
  for (const auto& [x, y] : polygon) points.push_back({x, y, 0});
  return points;
}

// Twice the signed areas of the triangles of a polygon in a plane.
std::vector<double> areas(const Polygon& polygon) {
  const mesh::Points points = in_a_plane(polygon);
  const mesh::Faces triangles = triangulated(polygon, points).triangles;
  std::vector<double> found;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto ring = triangles.ring(t);
    const auto &a = points[ring[0]], &b = points[ring[1]], &c = points[ring[2]];
    found.push_back((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return found;
}

// Nothing is covered twice and nothing outside: no triangle is turned, and their areas are that of the polygon.
void expect_covered(Polygon polygon, double twice_the_area) {
  for (std::size_t first = 0; first < polygon.size(); ++first) {
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    const std::vector<double> found = areas(polygon);
    EXPECT_EQ(found.size(), polygon.size() - 2);
    EXPECT_GE(*std::min_element(found.begin(), found.end()), 0) << "from corner " << first;
    EXPECT_EQ(std::accumulate(found.begin(), found.end(), 0.0), twice_the_area) << "from corner " << first;
  }
}

TEST(Triangulate, ACornerOnTheBorderOfAnEarStopsIt) {
  // (2, 2) lies on the diagonal of the ear at (4, 0), far from its ends along the outline.
  expect_covered({{0, 0}, {4, 0}, {4, 4}, {1, 4}, {2, 2}, {0, 2}}, 26);
  // Without that ear, and without any other, a corner would be cut that covers the outside.
  expect_covered({{0, 0}, {4, 0}, {4, 4}, {1, 4}, {2, 2}, {0, 2}, {-2, 2}, {-2, -1}}, 36);
}

TEST(Triangulate, AStaircaseIsCovered) {
  Polygon stairs{{0, 0}, {5, 0}};
  for (int i = 0; i < 5; ++i) stairs.insert(stairs.end(), {{5.0 - i, i + 1.0}, {4.0 - i, i + 1.0}});
  expect_covered(stairs, 30);
}

TEST(Triangulate, ACombIsCovered) {
  Polygon comb{{0, 0}, {6, 0}};
  for (int i = 0; i < 3; ++i) comb.insert(comb.end(), {{6 - 2.0 * i, 4}, {5 - 2.0 * i, 1}});
  comb.back() = {0, 4};
  const double twice = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < comb.size(); ++i) {
      const auto &a = comb[i], &b = comb[(i + 1) % comb.size()];
      sum += a[0] * b[1] - a[1] * b[0];
    }
    return sum;
  }();
  expect_covered(comb, twice);
}

// Nothing is outside: no triangle is turned.
void expect_no_turned_triangle(const Polygon& polygon) {
  const std::vector<double> found = areas(polygon);
  EXPECT_GE(*std::min_element(found.begin(), found.end()), 0);
}

// Its only ears are at its ends, on either side in turn.
TEST(Triangulate, ALongZigzagIsCoveredThroughout) {
  constexpr int teeth = 40000;
  Polygon zigzag;
  for (int k = 0; k <= teeth; ++k) zigzag.push_back({1.0 * k, 4.0 * (k % 2)});
  for (int k = teeth; k >= 0; --k) zigzag.push_back({1.0 * k, 4.0 * (k % 2) + 1});
  expect_no_turned_triangle(zigzag);
}

// Its line touches corners and runs back on itself, so there is no ear at first.
TEST(Triangulate, WithoutAnEarACornerWithoutAreaIsCut) {
  expect_no_turned_triangle({{3, 3}, {0, 3}, {1, 3}, {3, 1}});
  expect_no_turned_triangle({{1, 1}, {2, 2}, {0, 2}, {1, 1}, {1, 0}});
  expect_no_turned_triangle({{1, 3}, {0, 3}, {1, 0}, {0, 3}, {0, 1}, {3, 2}});
}

TEST(Triangulate, AnEarIsInsideAtBothEndsOfItsDiagonal) {
  expect_no_turned_triangle({{2, 3}, {3, 0}, {2, 2}, {0, 0}, {3, 0}});
  expect_no_turned_triangle({{0, 0}, {1, 2}, {0, 1}, {0, 3}, {2, 0}, {0, 3}});
  expect_no_turned_triangle({{2, 2}, {1, 3}, {1, 0}, {3, 1}, {1, 2}, {1, 1}, {1, 0}});
}

Polygon star(int corners, int step) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * step * i / corners;
    polygon.push_back({std::cos(angle), std::sin(angle)});
  }
  return polygon;
}

// A star that crosses itself everywhere has no ear at first, nor after most cuts.
TEST(Triangulate, AFaceThatTakesTooLongIsTold) {
  const Polygon many = star(40'001, 20'000), few = star(2001, 1000);
  EXPECT_EQ(triangulated(many, in_a_plane(many)).unfinished, std::vector<int>{7});
  EXPECT_EQ(triangulated(few, in_a_plane(few)).unfinished, std::vector<int>());
}

// Rounded to few decimals a round face is not convex, and its corners leave nearly all of its box empty.
TEST(Triangulate, ARoundFaceOfAMillionCornersIsDividedToTheEnd) {
  Polygon round = star(1'000'000, 1);
  for (auto& [x, y] : round) {
    x = std::round(5e8 * x) / 1e7;
    y = std::round(5e8 * y) / 1e7;
  }
  EXPECT_EQ(triangulated(round, in_a_plane(round)).unfinished, std::vector<int>());
}

// The box around each tooth of a slanted comb contains most of the other corners.
TEST(Triangulate, ASlantedCombIsDividedToTheEnd) {
  constexpr int teeth = 20'000;
  Polygon comb{{0, -1}, {1, -1}};
  for (int i = teeth; i > 0; --i) {
    const double from = static_cast<double>(i) / teeth, to = (i - 0.9) / teeth;
    comb.insert(comb.end(), {{from, 0}, {from + 1, 1}, {to, 0}});
  }
  EXPECT_EQ(triangulated(comb, in_a_plane(comb)).unfinished, std::vector<int>());
}

}  // namespace
}  // namespace epura::test::triangulate_test
