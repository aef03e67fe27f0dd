// SPDX-License-Identifier: Apache-2.0
#include "drawing/forwards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace epura::drawing::forwards_test {
namespace {

using Points = std::vector<Vec2>;

double length_of(const Points& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

// Points of a circle with a radius of 100, at these hundredths of a radian.
Points on_circle(const std::vector<double>& places) {
  Points points;
  for (const double place : places) points.push_back(100.0 * Vec2(std::cos(place / 100), std::sin(place / 100)));
  return points;
}

TEST(Forwards, PointsOfAnArcArePassedInTheirOrder) {
  const Points arc = on_circle({0, 1, 2, 3, 4, 5, 6});
  EXPECT_EQ(go_forwards(on_circle({0, 2, 1, 3, 4, 5, 6}), false, 0.05), arc);
  EXPECT_EQ(go_forwards(on_circle({0, 3, 2, 1, 4, 5, 6}), false, 0.05), arc);
  EXPECT_EQ(go_forwards(on_circle({0, 2, 1, 4, 3, 5, 6}), false, 0.05), arc);
  EXPECT_EQ(go_forwards(arc, false, 0.05), arc);
}

TEST(Forwards, AClosedLineGoesOnceAround) {
  std::vector<double> places;
  for (int i = 0; i < 100; ++i) places.push_back(2 * std::numbers::pi * i);
  const Points circle = on_circle(places);
  std::swap(places[40], places[41]);
  EXPECT_EQ(go_forwards(on_circle(places), true, 0.3), circle);
}

TEST(Forwards, ALineThatTurnsBackOnceStays) {
  const Points cusp{{0, 0}, {2, 0}, {4, 0}, {3, 0.01}, {1, 0.02}};
  EXPECT_EQ(go_forwards(cusp, false, 0.05), cusp);
}

// A web that is tangent to a boss: the rim comes to the long edge, and what lies between would be shorter reversed.
TEST(Forwards, AnArcThatEndsInATangentStays) {
  const Points arc_and_tangent{{3.765, -1.394}, {2.437, -0.998}, {1.178, -0.532}, {0, 0}, {60.481, -30.034}};
  EXPECT_EQ(go_forwards(arc_and_tangent, false, 0.06), arc_and_tangent);
}

TEST(Forwards, TeethHigherThanTheDistanceStay) {
  const auto teeth = [](double height) {
    return Points{{0, 0}, {1, height}, {0.8, 0}, {2, height}, {1.8, 0}, {3, height}};
  };
  EXPECT_EQ(go_forwards(teeth(0.5), false, 0.05), teeth(0.5));
  const Points lower = go_forwards(teeth(0.01), false, 0.05);
  EXPECT_LT(length_of(lower), 3.001);
  EXPECT_EQ(lower.size(), 6U);
}

// Lines that go back and forth at random, where one change rules out another.
Points zigzag(std::mt19937& random) {
  const auto up_to = [&](double most) { return std::ldexp(static_cast<double>(random() >> 8), -24) * most; };
  Points points;
  for (int i = 0; i < 12; ++i) points.emplace_back(i + up_to(4), up_to(0.2));
  return points;
}

TEST(Forwards, WhereALineBeginsMakesNoDifference) {
  std::mt19937 random(1);
  int changed = 0;
  for (int i = 0; i < 200; ++i) {
    const Points line = zigzag(random);
    const Points open = go_forwards(line, false, 0.15), ring = go_forwards(line, true, 0.15);
    changed += open != line || ring != line ? 1 : 0;
    Points other = go_forwards(Points(line.rbegin(), line.rend()), false, 0.15);
    std::ranges::reverse(other);
    EXPECT_EQ(other, open);
    for (std::size_t start = 0; start < line.size(); ++start) {
      Points turned(line);
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
      Points once = go_forwards(turned, true, 0.15);
      EXPECT_EQ(once.front(), turned.front());
      std::rotate(once.begin(), std::ranges::find(once, ring.front()), once.end());
      EXPECT_EQ(once, ring);
    }
  }
  EXPECT_GT(changed, 50);
}

TEST(Forwards, TheEndsStay) {
  const Points line{{1, 0}, {0, 0}, {2, 0}, {4, 0}, {3, 0}};
  const Points forwards = go_forwards(line, false, 0.05);
  EXPECT_EQ(forwards.front(), line.front());
  EXPECT_EQ(forwards.back(), line.back());
  EXPECT_EQ(go_forwards({{0, 0}, {1, 0}}, false, 1), (Points{{0, 0}, {1, 0}}));
}

}  // namespace
}  // namespace epura::drawing::forwards_test
