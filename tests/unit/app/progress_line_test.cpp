// SPDX-License-Identifier: Apache-2.0
#include "app/progress_line.hpp"

#include <gtest/gtest.h>

namespace epura::test {
namespace {

TEST(ProgressLine, HasBarPercentAndTheTimeLeft) {
  EXPECT_EQ(progress_line({"hiding lines", 42, 100, 21}, 100),
            "epura: hiding lines          [########------------]  42 %  0:29 left");
  EXPECT_EQ(progress_line({"hiding lines", 100, 100, 21}, 100),
            "epura: hiding lines          [####################] 100 %  0:00 left");
}

TEST(ProgressLine, BeforeAnythingIsDoneNoTimeIsPromised) {
  EXPECT_EQ(progress_line({"hiding lines", 0, 100, 21}, 100),
            "epura: hiding lines          [--------------------]   0 %");
}

TEST(ProgressLine, OfUnknownWorkTellsTheTimeSoFar) {
  EXPECT_EQ(progress_line({"reading", 0, 0, 61}, 100), "epura: reading               1:01");
}

TEST(ProgressLine, MoreDoneThanAnnouncedIsAllOfIt) {
  EXPECT_EQ(progress_line({"x", 7, 5, 1}, 100), "epura: x                     [####################] 100 %");
}

TEST(ProgressLine, IsNoWiderThanTheTerminal) {
  EXPECT_EQ(progress_line({"hiding lines", 42, 100, 21}, 20), "epura: hiding lines ");
  EXPECT_EQ(progress_line({"hiding lines", 42, 100, 21}, 0), "");
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
}  // namespace epura::test
