// SPDX-License-Identifier: Apache-2.0
#include "drawing/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epura::test::boundary_test {
namespace {

using drawing::Boundary;

constexpr double pi = std::numbers::pi;

Boundary circle(const Vec2& centre, double radius) { return {centre, Vec2(radius), true}; }
Boundary rectangle(const Vec2& centre, const Vec2& half) { return {centre, half, false}; }

double length_inside(const Boundary& boundary, const Vec2& from, const Vec2& to) {
  const auto part = drawing::part_inside(boundary, from, to);
  return part ? ((*part)[1] - (*part)[0]) * glm::distance(from, to) : 0;
}

double area_of(const std::vector<std::vector<Vec2>>& rings) {
  double area = 0;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      area += cross(a, b) / 2;
    }
  return area;
}

std::vector<Vec2> square(const Vec2& min, double side) {
  return {min, min + Vec2(side, 0), min + Vec2(side), min + Vec2(0, side)};
}

TEST(Boundary, OfACircleCutsChords) {
  const Boundary c = circle({3, 4}, 5);
  EXPECT_DOUBLE_EQ(length_inside(c, {-10, 4}, {20, 4}), 10);
  EXPECT_DOUBLE_EQ(length_inside(c, {-10, 7}, {20, 7}), 8);  // 3, 4, 5
  EXPECT_DOUBLE_EQ(length_inside(c, {3, 4}, {3, 40}), 5);
  EXPECT_DOUBLE_EQ(length_inside(c, {2, 4}, {4, 4}), 2);
  EXPECT_EQ(length_inside(c, {-10, 9}, {20, 9}), 0);  // touches
  EXPECT_EQ(length_inside(c, {-10, 10}, {20, 10}), 0);
  EXPECT_EQ(length_inside(c, {9, 4}, {20, 4}), 0);
  // From just outside to very far away.
  EXPECT_NEAR(length_inside(circle({0, 0}, 5), {-5.000001, 0}, {1e6, 0}), 10, 1e-9);
  // A tangent, of which the middle is on the circle up to rounding.
  EXPECT_EQ(length_inside(circle({100.5453125, 122.5}, 22), {108.54531250000001, 144.5}, {92.54531250000001, 144.5}),
            0);
  const auto part = drawing::part_inside(c, {2, 3}, {4, 5});
  ASSERT_TRUE(part);
  EXPECT_EQ((*part)[0], 0);
  EXPECT_EQ((*part)[1], 1);
}

TEST(Boundary, OfARectangleCutsAtItsSides) {
  const Boundary r = rectangle({10, 20}, {4, 3});
  EXPECT_DOUBLE_EQ(length_inside(r, {0, 20}, {100, 20}), 8);
  EXPECT_DOUBLE_EQ(length_inside(r, {10, 0}, {10, 100}), 6);
  EXPECT_DOUBLE_EQ(length_inside(r, {5, 16}, {15, 26}), std::sqrt(2) * 6);
  EXPECT_DOUBLE_EQ(length_inside(r, {0, 23}, {100, 23}), 8);  // a side belongs to it
  EXPECT_EQ(length_inside(r, {0, 23.001}, {100, 23.001}), 0);
  EXPECT_EQ(length_inside(r, {14, 10}, {24, 20}), 0);
}

TEST(Boundary, CutsAreasToTheirParts) {
  const Boundary c = circle({0, 0}, 10);
  // Chords are up to 0.0001 mm off the arc: at most that times its length.
  const double slack = 1e-4 * 2 * pi * 10;
  EXPECT_NEAR(area_of(drawing::area_inside(c, {square({-50, -50}, 100)})), 100 * pi, slack);
  EXPECT_NEAR(area_of(drawing::area_inside(c, {square({0, -50}, 100)})), 50 * pi, slack);
  EXPECT_NEAR(area_of(drawing::area_inside(c, {square({0, 0}, 100)})), 25 * pi, slack);
  EXPECT_DOUBLE_EQ(area_of(drawing::area_inside(c, {square({-2, -2}, 4)})), 16);
  EXPECT_TRUE(drawing::area_inside(c, {square({11, 11}, 4)}).empty());
  // A segment beyond a chord at a distance of 6.
  EXPECT_NEAR(area_of(drawing::area_inside(c, {square({6, -50}, 100)})), 100 * std::acos(0.6) - 6 * 8, slack);
  const Boundary r = rectangle({5, 5}, {5, 5});
  EXPECT_DOUBLE_EQ(area_of(drawing::area_inside(r, {square({5, 5}, 100)})), 25);
  EXPECT_DOUBLE_EQ(area_of(drawing::area_inside(r, {{{-10, -10}, {20, 20}, {-10, 20}}})), 50);
  EXPECT_TRUE(drawing::area_inside(r, {square({11, 0}, 4)}).empty());
}

TEST(Boundary, HolesStayHoles) {
  std::vector<Vec2> hole = square({-2, -2}, 4);
  std::reverse(hole.begin(), hole.end());
  const auto rings = drawing::area_inside(circle({2, 0}, 3), {square({-50, -50}, 100), hole});
  ASSERT_EQ(rings.size(), 2U);
  // The right side of the hole passes through the middle: the integral of sqrt(9 - y^2) from -2 to 2 is cut out.
  const double cut_out = 2 * std::sqrt(5) + 9 * std::asin(2.0 / 3);
  EXPECT_NEAR(area_of(rings), 9 * pi - cut_out, 1e-4 * 6 * pi);
}

double turn_of(const std::vector<drawing::AngleRange>& ranges) {
  double turn = 0;
  for (const drawing::AngleRange& range : ranges) turn += range.to - range.from;
  return turn;
}

TEST(Boundary, CutsCircles) {
  const Boundary c = circle({0, 0}, 10);
  EXPECT_DOUBLE_EQ(turn_of(drawing::circle_inside(c, {1, 1}, 2)), 2 * pi);
  EXPECT_TRUE(drawing::circle_inside(c, {0, 0}, 11).empty());
  EXPECT_TRUE(drawing::circle_inside(c, {30, 0}, 5).empty());
  // Circles of the same radius through each other's centres share a third of each.
  const auto lens = drawing::circle_inside(c, {10, 0}, 10);
  ASSERT_EQ(lens.size(), 1U);
  EXPECT_NEAR(lens[0].from, 2 * pi / 3, 1e-12);
  EXPECT_NEAR(lens[0].to, 4 * pi / 3, 1e-12);
  const auto across = drawing::circle_inside(circle({10, 0}, 10), {0, 0}, 10);  // passes the angle 0
  ASSERT_EQ(across.size(), 1U);
  EXPECT_NEAR(turn_of(across), 2 * pi / 3, 1e-12);
  // A rectangle that cuts off a cap of 60 degrees on either side.
  const auto belt = drawing::circle_inside(rectangle({0, 0}, {100, 5}), {0, 0}, 10);
  EXPECT_EQ(belt.size(), 2U);
  EXPECT_NEAR(turn_of(belt), 2 * pi / 3, 1e-12);
  const auto corner = drawing::circle_inside(rectangle({50, 50}, {50, 50}), {0, 0}, 10);
  EXPECT_NEAR(turn_of(corner), pi / 2, 1e-12);
}

}  // namespace
}  // namespace epura::test::boundary_test
