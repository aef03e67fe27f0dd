// SPDX-License-Identifier: Apache-2.0
#include "app/progress_line.hpp"

#include <gtest/gtest.h>

namespace epura::test::progress_line_test {
namespace {

/// The first line of a run.
std::string line(const Standing& standing, std::size_t width) {
  return progress_line(standing, TimeLeft().at(standing), width);
}

TEST(ProgressLine, TheTimeLeftNeverGrows) {
  TimeLeft left;
  EXPECT_DOUBLE_EQ(left.at({"reading", 49, 98, 1}).value(), 1);
  EXPECT_DOUBLE_EQ(left.at({"reading", 49, 98, 1.5}).value(), 0.5);  // nothing has been done since
  EXPECT_FALSE(left.at({"reading", 49, 98, 3}));
  EXPECT_FALSE(left.at({"reading", 50, 98, 4}));
  EXPECT_DOUBLE_EQ(left.at({"hiding", 1, 10, 2}).value(), 18);  // another stage
  EXPECT_DOUBLE_EQ(left.at({"hiding", 5, 10, 3}).value(), 3);   // faster than it seemed
  EXPECT_DOUBLE_EQ(left.at({"hiding", 6, 10, 5.5}).value(), 0.5);
  EXPECT_DOUBLE_EQ(left.at({"hiding", 0, 0, 1}).value_or(-1), -1);
}

TEST(ProgressLine, HasBarPercentAndTheTimeLeft) {
  EXPECT_EQ(line({"hiding lines", 42, 100, 21}, 100),
            "epura: hiding lines          [########------------]  42 %  0:29 left");
  EXPECT_EQ(line({"hiding lines", 100, 100, 21}, 100),
            "epura: hiding lines          [####################] 100 %  0:00 left");
}

TEST(ProgressLine, BeforeAnythingIsDoneNoTimeIsPromised) {
  EXPECT_EQ(line({"hiding lines", 0, 100, 21}, 100), "epura: hiding lines          [--------------------]   0 %");
}

TEST(ProgressLine, OfUnknownWorkTellsTheTimeSoFar) {
  EXPECT_EQ(line({"reading", 0, 0, 61}, 100), "epura: reading               1:01");
}

TEST(ProgressLine, MoreDoneThanAnnouncedIsAllOfIt) {
  EXPECT_EQ(line({"x", 7, 5, 1}, 100), "epura: x                     [####################] 100 %");
}

TEST(ProgressLine, IsNoWiderThanTheTerminal) {
  EXPECT_EQ(line({"hiding lines", 42, 100, 21}, 20), "epura: hiding lines ");
  EXPECT_EQ(line({"hiding lines", 42, 100, 21}, 0), "");
}

TEST(ProgressLine, ClocksRoundUp) {
  EXPECT_EQ(clock_text(0), "0:00");
  EXPECT_EQ(clock_text(0.1), "0:01");
  EXPECT_EQ(clock_text(59.5), "1:00");
  EXPECT_EQ(clock_text(125), "2:05");
  EXPECT_EQ(clock_text(3599.5), "1:00:00");
  EXPECT_EQ(clock_text(3725), "1:02:05");
  EXPECT_EQ(clock_text(1e300), "100:00:00");
}

}  // namespace
}  // namespace epura::test::progress_line_test
