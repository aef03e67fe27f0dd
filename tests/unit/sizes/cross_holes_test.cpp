// SPDX-License-Identifier: Apache-2.0
// All vertices of a hole through a shaft are on the shaft, too. What would break if its walls were taken for facets of
// the shaft: the hole would not be drawn, and have no size.
#include <gtest/gtest.h>

#include "crossed_parts.hpp"
#include "dimensioned_part.hpp"

namespace epura::test::cross_holes_test {
namespace {

TEST(CrossHoles, AreFoundInCoarseShafts) {
  for (const int rings : {3, 4, 8})
    for (int i = 0; i < 10; ++i) {
      const double radius = 2 + 0.5 * i;
      SCOPED_TRACE(std::to_string(rings) + " rings, radius " + std::to_string(radius));
      const features::PartFeatures features =
          features::features_to_dimension(world_of(shaft_with_cross_hole(5 + 4 * i, 12 + i, radius, rings)));
      ASSERT_EQ(features.holes.size(), 1U);
      EXPECT_TRUE(features.holes[0].through);
      EXPECT_NEAR(features.holes[0].diameter, 2 * radius, 1e-3);
    }
}

}  // namespace
}  // namespace epura::test::cross_holes_test
