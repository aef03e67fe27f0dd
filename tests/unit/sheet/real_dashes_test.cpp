// SPDX-License-Identifier: Apache-2.0
#include "sheet/real_dashes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace epura::real_dashes_test {
namespace {

constexpr double pi = std::numbers::pi;

sheet::Sheet sheet_of(sheet::Stroke stroke) {
  return {100, 100, "", {{"front/hidden", {"hidden", 0.25, {3, 1}}, {std::move(stroke)}}}};
}

const std::vector<sheet::Stroke>& strokes(const sheet::Sheet& sheet) { return sheet.layers[0].strokes; }

TEST(RealDashes, AreLinesBetweenGaps) {
  sheet::Stroke line{{{10, 10}, {21, 10}}};
  line.dashes = {3, 1};
  line.edges = {{0, {1, 2}}};
  const sheet::Sheet real = sheet::with_real_dashes(sheet_of(line));
  EXPECT_FALSE(real.layers[0].style.dashes.dash > 0);
  ASSERT_EQ(strokes(real).size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const sheet::Stroke& dash = strokes(real)[i];
    const double from = 10 + 4.0 * static_cast<double>(i);
    ASSERT_EQ(dash.points.size(), 2U);
    EXPECT_NEAR(dash.points[0].x, from, 1e-9);
    EXPECT_NEAR(dash.points[1].x, from + 3, 1e-9);
    EXPECT_FALSE(dash.dashes.dash > 0);
    EXPECT_EQ(dash.edges, line.edges);
  }
}

TEST(RealDashes, BendAtCornersAndKeepDots) {
  sheet::Stroke line{{{0, 0}, {2, 0}, {2, 20}}};
  line.dashes = {5, 1, 0.5, 1};
  const sheet::Sheet real = sheet::with_real_dashes(sheet_of(line));
  // 0-5, 6-6.5, 7.5-12.5, 13.5-14, 15-20, 21-21.5 of 22 mm.
  ASSERT_EQ(strokes(real).size(), 6U);
  EXPECT_EQ(strokes(real)[0].points, (std::vector<Vec2>{{0, 0}, {2, 0}, {2, 3}}));
  EXPECT_NEAR(strokes(real)[1].points[0].y, 4, 1e-9);
  EXPECT_NEAR(strokes(real)[1].points[1].y, 4.5, 1e-9);
  EXPECT_NEAR(strokes(real)[5].points[1].y, 19.5, 1e-9);
}

TEST(RealDashes, OfArcsAreArcs) {
  const double radius = 10;
  sheet::Stroke arc{{}};
  for (int i = 0; i <= 12; ++i)
    arc.points.emplace_back(50 + radius * std::cos(pi * i / 12), 50 + radius * std::sin(pi * i / 12));
  arc.curves = {{0, 12, {50, 50}, {radius, 0}, {0, radius}, 0, pi}};
  arc.pattern = {2, 1, 4, 1, 100};
  const sheet::Sheet real = sheet::with_real_dashes(sheet_of(arc));
  ASSERT_EQ(strokes(real).size(), 3U);
  const auto ends = [&](std::size_t i) {
    EXPECT_EQ(strokes(real)[i].curves.size(), 1U);
    const drawing::CurvePart& curve = strokes(real)[i].curves.at(0);
    EXPECT_EQ(curve.first, 0);
    EXPECT_EQ(curve.last, static_cast<int>(strokes(real)[i].points.size()) - 1);
    return std::array{radius * curve.from, radius * curve.to};
  };
  EXPECT_NEAR(ends(0)[1], 2, 1e-3);
  EXPECT_NEAR(ends(1)[0], 3, 1e-3);
  EXPECT_NEAR(ends(1)[1], 7, 1e-3);
  EXPECT_NEAR(ends(2)[1], pi * radius, 1e-9);
}

TEST(RealDashes, KeepContinuousLinesAndTheInkOfDimensions) {
  sheet::Stroke closed{{{10, 10}, {20, 10}, {20, 20}}, true};
  sheet::Sheet sheet = sheet_of(closed);
  sheet::Stroke dashed{{{0, 0}, {7, 0}}};
  dashed.dashes = {3, 1};
  sheet.layers[0].strokes.insert(sheet.layers[0].strokes.begin(), dashed);
  sheet::DimensionObject object{sheet::DimensionShape::linear, {{0, 0}, {7, 0}, {7, 0}}};
  object.strokes = {1, 2};
  sheet.layers[0].dimensions.push_back(object);
  const sheet::Sheet real = sheet::with_real_dashes(sheet);
  ASSERT_EQ(strokes(real).size(), 3U);
  EXPECT_EQ(strokes(real)[2].points, closed.points);
  EXPECT_TRUE(strokes(real)[2].closed);
  EXPECT_EQ(real.layers[0].dimensions[0].strokes.begin, 2U);
  EXPECT_EQ(real.layers[0].dimensions[0].strokes.end, 3U);
}

// The dashes of a closed line go around its corners, too.
TEST(RealDashes, GoAroundClosedLines) {
  sheet::Stroke ring{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
  ring.dashes = {6, 4};
  const sheet::Sheet real = sheet::with_real_dashes(sheet_of(ring));
  ASSERT_EQ(strokes(real).size(), 4U);
  double length = 0;
  for (const sheet::Stroke& dash : strokes(real))
    for (std::size_t i = 0; i + 1 < dash.points.size(); ++i)
      length += glm::distance(dash.points[i], dash.points[i + 1]);
  EXPECT_NEAR(length, 24, 1e-9);
}

}  // namespace
}  // namespace epura::real_dashes_test
