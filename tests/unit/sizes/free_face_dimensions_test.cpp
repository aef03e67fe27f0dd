// SPDX-License-Identifier: Apache-2.0
// Dimensions of faces that belong to no feature which has dimensions of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "dimensioned_part.hpp"
#include "known_parts.hpp"
#include "sizes/coordinates.hpp"

namespace epura::test::free_face_dimensions_test {
namespace {

/// An arc about a point, from one direction to another, in degrees.
Loop arc(const Vec2& centre, double radius, double from, double to) {
  constexpr int steps = 24;
  Loop points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = (from + (to - from) * i / steps) * std::numbers::pi / 180;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

// 60 x 40, 40 deep; a bulge of the radius leaves the right side, about a point within.
std::string bulged_block(const Vec2& centre, double radius) {
  const double half = std::acos((60 - centre.x) / radius) * 180 / std::numbers::pi;
  Loop outline{{0, 0}, {60, 0}};
  for (const Vec2& point : arc(centre, radius, -half, half)) outline.push_back(point);
  outline.push_back({60, 40});
  outline.push_back({0, 40});
  return block(outline, 40);
}

// 60 wide, 40 deep; the top is an arc between the sides.
std::string crowned_block(const Vec2& centre, double radius) {
  const auto angle = [&](double x) { return std::acos((x - centre.x) / radius) * 180 / std::numbers::pi; };
  Loop outline{{0, 0}, {60, 0}};
  for (const Vec2& point : arc(centre, radius, angle(60), angle(0))) outline.push_back(point);
  return block(outline, 40);
}

// How many of its dimensions are missed if they are left out.
std::size_t needed(const DimensionedPart& sheet) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sheet.texts.size(); ++i)
    if (!sheet.free_without(i).free.empty()) ++count;
  return count;
}

void expect_defined(const DimensionedPart& sheet, const std::string& name) {
  const sheet::FreeFaces free = sheet.free();
  for (const sheet::FreeFace& one : free.free) ADD_FAILURE() << name << ": " << one.sentence;
  EXPECT_EQ(free.count.given, free.count.all) << name;
  EXPECT_TRUE(free.contradictory.empty() && free.untrue.empty() && free.undecided.empty()) << name;
  EXPECT_EQ(needed(sheet), sheet.texts.size()) << name << ": each is needed";
  const auto rebuilt = sheet.rebuilt();
  ASSERT_TRUE(rebuilt) << name;
  EXPECT_TRUE(rebuilt->is_defined()) << name;
}

// A round bar with notches all around, as of a knurl.
Loop knurl(int count, double tip, double root, double half) {
  Loop outline;
  for (int i = 0; i < count; ++i) {
    const double at = 360.0 * i / count, next = 360.0 * (i + 1) / count;
    outline.push_back(root * Vec2(cosine(at), sine(at)));
    for (const Vec2& point : arc({0, 0}, tip, at + half, next - half)) outline.push_back(point);
  }
  return outline;
}

}  // namespace

// Width, height, depth, the radius and the place of its centre; how far the bulge goes out follows.
TEST(FreeFaceDimensions, GiveTheHeightOfABulge) {
  for (int i = 0; i < 6; ++i) {
    const DimensionedPart sheet(bulged_block({50.0 + i, 15.0 + i}, 14 + 0.5 * i));
    expect_defined(sheet, "a bulge " + std::to_string(i));
    EXPECT_EQ(sheet.texts.size(), 6U) << i;
  }
}

TEST(FreeFaceDimensions, GiveThePlaceOfACrown) {
  for (int i = 0; i < 6; ++i) {
    const DimensionedPart sheet(crowned_block({22.0 + i, -20.0 + i}, 50));
    expect_defined(sheet, "a crown " + std::to_string(i));
  }
}

// Nobody dimensions each flank of a knurl: those that are too many are told.
TEST(FreeFaceDimensions, LeaveOutPatternsOfFaces) {
  for (const int count : {10, 14, 16}) {
    const DimensionedPart sheet(block(knurl(count, 15, 13.6, 5), 30));
    EXPECT_LE(sheet.texts.size(), 6U) << count;
    std::size_t told = 0;
    for (const auto& [view, number] : sheet.omitted.too_many) told += number;
    EXPECT_GT(told, sheet::max_parallel) << count;
    EXPECT_FALSE(sheet.free().free.empty()) << count;
  }
}

// Sides that lean alike have one angle between them, with their number.
TEST(FreeFaceDimensions, GiveEqualSlopesOneAngle) {
  for (const double degrees : {35.0, 65.0}) {
    const double in = 20 / std::tan(degrees * std::numbers::pi / 180);
    const DimensionedPart sheet(block({{0, 0}, {70, 0}, {70, 10}, {70 - in, 30}, {in, 30}, {0, 10}}, 25));
    expect_defined(sheet, "slopes of " + std::to_string(degrees));
    EXPECT_EQ(std::ranges::count(sheet.texts, "2× <>"), 1) << degrees;
  }
}

}  // namespace epura::test::free_face_dimensions_test
