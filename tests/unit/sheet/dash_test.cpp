// SPDX-License-Identifier: Apache-2.0
#include "sheet/dash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace epura::dash_test {
namespace {

TEST(Dash, OpenLinesBeginAndEndWithADash) {
  for (double length = 6.75; length < 500; length *= 1.0373) {
    const sheet::Dashes dashes = sheet::fit_open(length, 0.25);
    EXPECT_DOUBLE_EQ(dashes.gap, 0.75);
    // A whole number of gaps, and one dash more.
    const double gaps = (length - dashes.dash) / (dashes.dash + dashes.gap);
    EXPECT_NEAR(gaps, std::round(gaps), 1e-9) << length;
    EXPECT_GE(std::round(gaps), 1);
    // Close to the nominal 12 widths.
    EXPECT_GT(dashes.dash, 2) << length;
    EXPECT_LT(dashes.dash, 4) << length;
  }
  EXPECT_NEAR(sheet::fit_open(95, 0.25).dash, (95 - 25 * 0.75) / 26, 1e-12);  // n = round(92 / 3.75) = 25
}

TEST(Dash, ClosedLinesHaveAsManyDashesAsGaps) {
  for (double length = 6.75; length < 500; length *= 1.0373) {
    const sheet::Dashes dashes = sheet::fit_closed(length, 0.25);
    const double periods = length / (dashes.dash + dashes.gap);
    EXPECT_NEAR(periods, std::round(periods), 1e-9) << length;
    EXPECT_GT(dashes.dash, 1.8) << length;
    EXPECT_LT(dashes.dash, 4.5) << length;
  }
}

TEST(Dash, ShortLinesAreContinuous) {
  EXPECT_EQ(sheet::fit_open(3.74, 0.25).dash, 0);
  EXPECT_NEAR(sheet::fit_open(3.75, 0.25).dash, 1.5, 1e-12) << "two dashes";
  EXPECT_NEAR(sheet::fit_open(6.5, 0.25).dash, (6.5 - 0.75) / 2, 1e-12) << "two dashes";
  EXPECT_EQ(sheet::fit_open(13.6, 0.25, scene::long_dash_dot).dash, 0);
  EXPECT_GT(sheet::fit_crossings(5, 0.25, false, std::vector{2.5}).dashes.dash, 0) << "it looks dashed";
  EXPECT_EQ(sheet::fit_closed(6.74, 0.25).dash, 0);
  EXPECT_EQ(sheet::fit_open(0, 0.25).dash, 0);
}

TEST(Dash, LinesAreCutAtCornersFarEnoughApart) {
  const auto runs = sheet::cut_at_corners({{0, 0}, {20, 0}, {20, 3}, {20, 30}}, false, 6.75);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].first, 0);
  EXPECT_EQ(runs[0].last, 1);
  EXPECT_EQ(runs[1].first, 1);
  EXPECT_EQ(runs[1].last, 3);
  EXPECT_EQ(sheet::cut_at_corners({{0, 0}, {20, 0}, {20, 3}}, false, 6.75).size(),
            1u);  // 3 mm are too short for dashes
  EXPECT_EQ(sheet::cut_at_corners({{0, 0}, {20, 0}, {40, 5}}, false, 6.75).size(), 1u);  // 14 degrees are no corner
}

// A quarter of a circle at the end of a line, with one corner inside it, at which it turns by 45 degrees.
TEST(Dash, CurvesHaveCornersAtTheirEndsOnly) {
  const double c = 10 * std::sqrt(0.5);
  const std::vector<Vec2> points{{0, 0}, {20, 0}, {10 + c, c}, {10, 10}};
  const std::vector<drawing::CurvePart> curves{{1, 3, {10, 0}, {10, 0}, {0, 10}, 0, std::numbers::pi / 2}};
  const auto runs = sheet::cut_at_corners(points, false, 6.75, curves);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].last, 1);
  EXPECT_EQ(runs[1].first, 1);
  EXPECT_EQ(runs[1].last, 3);
  EXPECT_EQ(sheet::cut_at_corners(points, false, 6.75).size(), 3U);
}

TEST(Dash, StepsTooShortToBeSeenAreNoCorners) {
  EXPECT_EQ(sheet::cut_at_corners({{0, 0}, {20, 0}, {20, 0.01}, {40, 1}}, false, 6.75).size(), 1u);
  EXPECT_EQ(sheet::cut_at_corners({{0, 0}, {20, 0}, {20, 0.01}, {20, 20}}, false, 6.75).size(), 2u);
}

TEST(Dash, ClosedLinesBeginAtACorner) {
  // A square whose list of points begins in the middle of a side.
  const auto runs = sheet::cut_at_corners({{10, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}}, true, 6.75);
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].first, 1);
  EXPECT_EQ(runs[3].last, 6);
  for (const sheet::DashRun& run : runs) EXPECT_FALSE(run.closed);
}

TEST(Dash, RoundClosedLinesStayClosed) {
  std::vector<Vec2> circle;
  for (int i = 0; i < 40; ++i)
    circle.emplace_back(10 * std::cos(i * std::acos(-1) / 20), 10 * std::sin(i * std::acos(-1) / 20));
  const auto runs = sheet::cut_at_corners(circle, true, 6.75);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_TRUE(runs[0].closed);
  EXPECT_NEAR(sheet::length_of(circle, true), 800 * std::sin(std::acos(-1) / 40), 1e-9);
}

// Whether there is ink at a distance from the beginning.
bool has_ink(const sheet::FittedDashes& fitted, double at) {
  constexpr double slack = 1e-9;
  if (fitted.pattern.empty())
    return std::fmod(at + slack, fitted.dashes.dash + fitted.dashes.gap) <= fitted.dashes.dash + 2 * slack;
  double end = 0;
  for (std::size_t i = 0; i < fitted.pattern.size(); ++i) {
    end += fitted.pattern[i];
    if (at < end + slack) return i % 2 == 0;
  }
  return at <= end;
}

// The longest stretch in which crossings, and ends, follow each other too closely for a dash and a gap between them.
double crowded_stretch(std::vector<double> crossings, double length) {
  crossings.insert(crossings.begin(), 0);
  crossings.push_back(length);
  double longest = 0;
  for (std::size_t i = 1, first = 0; i < crossings.size(); ++i) {
    if (crossings[i] - crossings[i - 1] > 3.75) first = i;
    longest = std::max(longest, crossings[i] - crossings[first]);
  }
  return longest;
}

// Unless they are so many that dashes would be more than 8 mm long.
TEST(Dash, CrossingsHaveInk) {
  std::mt19937 random(7);
  int patterns = 0, unheeded = 0;
  for (int round = 0; round < 2000; ++round) {
    const double length = 7 + static_cast<double>(random() % 2000) / 10;
    std::vector<double> crossings;
    for (unsigned i = 0; i < random() % 12; ++i)
      crossings.push_back(length * static_cast<double>(random() % 1001) / 1000);
    std::sort(crossings.begin(), crossings.end());
    const bool closed = round % 2 == 0;
    const sheet::FittedDashes fitted = sheet::fit_crossings(length, 0.25, closed, crossings);
    const auto inked = [&](double at) { return has_ink(fitted, at); };
    if (!std::all_of(crossings.begin(), crossings.end(), inked)) {
      ++unheeded;
      EXPECT_EQ(fitted.dashes, closed ? sheet::fit_closed(length, 0.25) : sheet::fit_open(length, 0.25));
      EXPECT_GT(crowded_stretch(crossings, length), 3) << round;
    }
    EXPECT_TRUE(has_ink(fitted, 0));
    if (fitted.pattern.empty()) continue;
    ++patterns;
    // Ink and gaps fill the line; the last gap lies beyond it. Without crossings near each other dashes keep their
    // size.
    EXPECT_NEAR(std::accumulate(fitted.pattern.begin(), fitted.pattern.end() - 1, 0.0), length, 1e-9);
    for (std::size_t i = 1; i < fitted.pattern.size(); i += 2) EXPECT_NEAR(fitted.pattern[i], 0.75, 1e-9);
    for (std::size_t i = 0; i < fitted.pattern.size(); i += 2) EXPECT_GE(fitted.pattern[i], 4.5 * 0.25);
    for (std::size_t i = 0; i < fitted.pattern.size(); i += 2) EXPECT_LE(fitted.pattern[i], 8);
  }
  EXPECT_GT(patterns, 20);
  EXPECT_LT(unheeded, 200);
}

TEST(Dash, OtherLengthsComeBeforePatterns) {
  const sheet::Dashes usual = sheet::fit_open(60, 0.25);
  const sheet::FittedDashes fitted = sheet::fit_crossings(60, 0.25, false, std::vector{usual.dash + usual.gap / 2});
  EXPECT_TRUE(fitted.pattern.empty());
  EXPECT_NE(fitted.dashes, usual);
  const double gaps = (60 - fitted.dashes.dash) / (fitted.dashes.dash + fitted.dashes.gap);
  EXPECT_NEAR(gaps, std::round(gaps), 1e-9);
}

// ISO 128-2: n = round((L - 24 d) / 30.5 d), long dash = (L - 6.5 d n) / (n + 1).
TEST(Dash, ChainLinesAreFittedToo) {
  const sheet::Dashes dashes = sheet::fit_open(100, 0.25, scene::long_dash_dot);
  const double n = std::round((100 - 6) / 7.625);
  EXPECT_DOUBLE_EQ(dashes.dash, (100 - 1.625 * n) / (n + 1));
  EXPECT_EQ(dashes.dots, 1);
  EXPECT_EQ(sheet::fit_open(54.4 * 0.25, 0.25, scene::long_dash_dot).dash, 0);
  EXPECT_GT(sheet::fit_open(54.5 * 0.25, 0.25, scene::long_dash_dot).dash, 0);
  EXPECT_EQ(sheet::fit_open(57.9 * 0.25, 0.25, scene::long_dash_double_dot).dash, 0);
  EXPECT_EQ(sheet::fit_open(58 * 0.25, 0.25, scene::long_dash_double_dot).dots, 2);
}

}  // namespace
}  // namespace epura::dash_test
