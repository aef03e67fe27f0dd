// SPDX-License-Identifier: Apache-2.0
// What slots leave of rounded edges.
#include "design/design_features.hpp"

#include <gtest/gtest.h>

namespace epura::test {
namespace {

TEST(DesignRounds, ReachOnlyWhereSlotsLeftThem) {
  design::DesignRound round{0, Vec3(0), Vec3(0, 0, 1), 10, 1, {0, 90}};
  EXPECT_TRUE(round.reaches(Vec3(1, 0, 0))) << "a full turn";
  round.sectors = {{Vec3(0, 1, 0), 80}, {Vec3(0, -1, 0), 80}};
  EXPECT_FALSE(round.reaches(Vec3(1, 0, 0)));
  EXPECT_FALSE(round.reaches(Vec3(-1, 0, 0)));
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(round.reaches(Vec3(0, side, 0)));
    EXPECT_TRUE(round.reaches(glm::normalize(Vec3(1, side, 0))));
  }
}

}  // namespace
}  // namespace epura::test
