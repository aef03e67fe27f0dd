#include "sheet/dash.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura {
namespace {

TEST(Dash, OpenLinesBeginAndEndWithADash) {
  for (double length = 6.75; length < 500; length *= 1.0373) {
    const Dashes dashes = fit_open(length, 0.25);
    EXPECT_DOUBLE_EQ(dashes.gap, 0.75);
    // A whole number of gaps, and one dash more.
    const double gaps = (length - dashes.dash) / (dashes.dash + dashes.gap);
    EXPECT_NEAR(gaps, std::round(gaps), 1e-9) << length;
    EXPECT_GE(std::round(gaps), 1);
    // Close to the nominal 12 widths.
    EXPECT_GT(dashes.dash, 2) << length;
    EXPECT_LT(dashes.dash, 4) << length;
  }
  EXPECT_NEAR(fit_open(95, 0.25).dash, (95 - 25 * 0.75) / 26, 1e-12);  // n = round(92 / 3.75) = 25
}

TEST(Dash, ClosedLinesHaveAsManyDashesAsGaps) {
  for (double length = 6.75; length < 500; length *= 1.0373) {
    const Dashes dashes = fit_closed(length, 0.25);
    const double periods = length / (dashes.dash + dashes.gap);
    EXPECT_NEAR(periods, std::round(periods), 1e-9) << length;
    EXPECT_GT(dashes.dash, 1.8) << length;
    EXPECT_LT(dashes.dash, 4.5) << length;
  }
}

TEST(Dash, ShortLinesAreContinuous) {
  EXPECT_EQ(fit_open(6.74, 0.25).dash, 0);
  EXPECT_GT(fit_open(6.75, 0.25).dash, 0);
  EXPECT_EQ(fit_closed(6.74, 0.25).dash, 0);
  EXPECT_EQ(fit_open(0, 0.25).dash, 0);
}

TEST(Dash, LinesAreCutAtCornersFarEnoughApart) {
  const auto runs = cut_at_corners({{0, 0}, {20, 0}, {20, 3}, {20, 30}}, false, 0.25);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].first, 0);
  EXPECT_EQ(runs[0].last, 1);
  EXPECT_EQ(runs[1].first, 1);
  EXPECT_EQ(runs[1].last, 3);
  EXPECT_EQ(cut_at_corners({{0, 0}, {20, 0}, {20, 3}}, false, 0.25).size(), 1u);  // 3 mm are too short for dashes
  EXPECT_EQ(cut_at_corners({{0, 0}, {20, 0}, {40, 5}}, false, 0.25).size(), 1u);  // 14 degrees are no corner
}

TEST(Dash, ClosedLinesBeginAtACorner) {
  // A square whose list of points begins in the middle of a side.
  const auto runs = cut_at_corners({{10, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}}, true, 0.25);
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].first, 1);
  EXPECT_EQ(runs[3].last, 6);
  for (const DashRun& run : runs) EXPECT_FALSE(run.closed);
}

TEST(Dash, RoundClosedLinesStayClosed) {
  std::vector<Vec2> circle;
  for (int i = 0; i < 40; ++i)
    circle.emplace_back(10 * std::cos(i * std::acos(-1) / 20), 10 * std::sin(i * std::acos(-1) / 20));
  const auto runs = cut_at_corners(circle, true, 0.25);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_TRUE(runs[0].closed);
  EXPECT_NEAR(length_of(circle, true), 800 * std::sin(std::acos(-1) / 40), 1e-9);
}

}  // namespace
}  // namespace epura
