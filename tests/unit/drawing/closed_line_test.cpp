// SPDX-License-Identifier: Apache-2.0
#include "drawing/closed_line.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "drawing/freehand.hpp"
#include "drawing/limits.hpp"

namespace epura::test::closed_line_test {
namespace {

using drawing::ClosedLine;
using Rings = std::vector<std::vector<Vec2>>;

// An L: 10 x 10 without its upper right quarter.
ClosedLine corner() { return ClosedLine({{0, 0}, {10, 0}, {10, 5}, {5, 5}, {5, 10}, {0, 10}}); }

std::vector<Vec2> rectangle(const Vec2& min, const Vec2& max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

double signed_area(const std::vector<Vec2>& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    area += cross(a, b) / 2;
  }
  return area;
}

bool contains(const Rings& rings, const Vec2& p) {
  bool inside = false;
  for (const std::vector<Vec2>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y > p.y) != (b.y > p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) inside = !inside;
    }
  return inside;
}

double length_of(const std::vector<Vec2>& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
  return length;
}

TEST(ClosedLine, DividesLines) {
  const auto inside = corner().parts({-10, 7}, {10, 7}, true);
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_DOUBLE_EQ(inside[0][0], 0.5);
  EXPECT_DOUBLE_EQ(inside[0][1], 0.75);
  const auto outside = corner().parts({-10, 7}, {10, 7}, false);
  ASSERT_EQ(outside.size(), 2U);
  EXPECT_DOUBLE_EQ(outside[0][1], 0.5);
  EXPECT_DOUBLE_EQ(outside[1][0], 0.75);
  EXPECT_EQ(outside[1][1], 1);
  // From one leg to the other, across the notch.
  const auto across = corner().parts({2, 9}, {9, 2}, true);
  ASSERT_EQ(across.size(), 2U);
  EXPECT_DOUBLE_EQ(across[0][1], 3.0 / 7);
  EXPECT_DOUBLE_EQ(across[1][0], 4.0 / 7);
  EXPECT_TRUE(corner().parts({6, 6}, {9, 9}, true).empty());
  EXPECT_EQ(corner().parts({1, 1}, {4, 9}, true), (std::vector<std::array<double, 2>>{{0, 1}}));
}

TEST(ClosedLine, DividesAreas) {
  const auto area = [](const Rings& rings) {
    double sum = 0;
    for (const auto& ring : corner().area(rings)) sum += std::abs(signed_area(ring));
    return sum;
  };
  EXPECT_DOUBLE_EQ(area({rectangle({2, 2}, {8, 8})}), 36 - 9);
  EXPECT_DOUBLE_EQ(area({rectangle({-5, -5}, {20, 20})}), 75);
  EXPECT_DOUBLE_EQ(area({rectangle({6, 6}, {20, 20})}), 0);
  EXPECT_DOUBLE_EQ(area({rectangle({1, 1}, {3, 4})}), 6);
  // Two parts of one area.
  EXPECT_DOUBLE_EQ(area({{{12, 1}, {12, 12}, {1, 12}, {1, 9}, {9, 9}, {9, 1}}}), 4 + 4);
  // Sides on top of each other: decided up to a displacement that no drawing shows.
  EXPECT_NEAR(area({corner().corners()}), 75, 1e-5);
  EXPECT_NEAR(area({rectangle({0, 0}, {5, 10})}), 50, 1e-5);
  // An island in a hole.
  const Rings holed{rectangle({1, 1}, {4, 9}), rectangle({2, 2}, {3, 8}), rectangle({2.25, 3}, {2.75, 4})};
  const Rings common = corner().area(holed);
  EXPECT_EQ(common.size(), 3U);
  EXPECT_FALSE(contains(common, {2.5, 6}));
  EXPECT_TRUE(contains(common, {2.5, 3.5}));
}

// Each point is inside the result if it is inside both.
TEST(ClosedLine, DividesAreasAtEveryPoint) {
  std::mt19937 random(7);
  const auto number = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
  for (int run = 0; run < 50; ++run) {
    Rings rings(3);
    for (auto& ring : rings)
      for (int i = 0; i < 7; ++i) ring.emplace_back(number(10), number(10));
    std::vector<Vec2> corners;
    for (int i = 0; i < 9; ++i) corners.emplace_back(number(10), number(10));
    const ClosedLine line(corners);
    const Rings common = line.area(rings);
    for (int i = 0; i < 300; ++i) {
      const Vec2 p(number(10), number(10));
      EXPECT_EQ(contains(common, p), contains({corners}, p) && contains(rings, p));
      EXPECT_EQ(line.contains(p), contains({corners}, p));
    }
  }
}

TEST(ClosedLine, IsCoveredByTriangles) {
  using Triangle = std::array<Vec2, 3>;
  // The half below y = 7.
  const std::vector<Triangle> lower{{Vec2(-5, -5), {15, -5}, {15, 7}}, {Vec2(-5, -5), {15, 7}, {-5, 7}}};
  const auto lines = corner().covered(lower);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_DOUBLE_EQ(length_of(lines[0]), 2 + 5 + 5 + 10 + 7);
  EXPECT_EQ(lines[0].front(), Vec2(0, 7));
  EXPECT_EQ(lines[0].back(), Vec2(5, 7));
  const std::vector<Triangle> notch{{Vec2(4, -1), {6, -1}, {6, 1}}, {Vec2(4, -1), {6, 1}, {4, 1}}};
  const auto parts = corner().covered(lower, notch);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_DOUBLE_EQ(length_of(parts[0]) + length_of(parts[1]), 29 - 2);
  const std::vector<Triangle> all{{Vec2(-50, -50), {50, -50}, {0, 100}}};
  const auto whole = corner().covered(all);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].front(), whole[0].back());
  EXPECT_DOUBLE_EQ(length_of(whole[0]), 40);
  EXPECT_TRUE(corner().covered({}).empty());
  EXPECT_TRUE(corner().covered(all, all).empty());
}

TEST(ClosedLine, Overlaps) {
  EXPECT_TRUE(overlap(corner(), ClosedLine(rectangle({4, 4}, {8, 8}))));
  EXPECT_FALSE(overlap(corner(), ClosedLine(rectangle({6, 6}, {8, 8}))));
  EXPECT_TRUE(overlap(corner(), ClosedLine(rectangle({1, 1}, {2, 2}))));
  EXPECT_TRUE(overlap(ClosedLine(rectangle({1, 1}, {2, 2})), corner()));
}

TEST(Freehand, StaysBesideTheCircle) {
  for (const double radius : {4.0, 20.0, 150.0}) {
    const Vec2 centre(30, 40);
    const std::vector<Vec2> line = drawing::freehand_around(drawing::points_on_circle(centre, radius));
    double least = HUGE_VAL, most = 0, longest = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      least = std::min(least, glm::distance(line[i], centre));
      most = std::max(most, glm::distance(line[i], centre));
      longest = std::max(longest, glm::distance(line[i], line[(i + 1) % line.size()]));
    }
    // The curve through 24 points of a circle is off it by less than 0.0005 of its radius.
    EXPECT_GE(least, radius - drawing::freehand_wave - 5e-4 * radius);
    EXPECT_LE(most, radius + drawing::freehand_wave + 5e-4 * radius);
    EXPECT_GT(most - least, drawing::freehand_wave);
    EXPECT_LT(longest, 0.5);
    EXPECT_NEAR(std::abs(signed_area(line)), std::numbers::pi * radius * radius,
                2 * std::numbers::pi * radius * drawing::freehand_wave);
  }
}

}  // namespace
}  // namespace epura::test::closed_line_test
