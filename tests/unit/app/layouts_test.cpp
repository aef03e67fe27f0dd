// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: sheets that leave something out at a scale, and not at a larger one.
#include <gtest/gtest.h>

#include "composition/layout.hpp"

namespace epura::layouts_test {
namespace {

TEST(Layouts, ALargerScaleIsTriedBeforeSmallerOnes) {
  pipeline::SheetPlan usual;
  usual.chosen = true;
  usual.scale = 0.1;
  const std::vector<pipeline::LayoutRequest> layouts = pipeline::roomier_layouts({}, usual);
  ASSERT_GT(layouts.size(), 3U);
  EXPECT_EQ(layouts[0].kept_scale, 0.2);
  EXPECT_EQ(layouts[1].kept_scale, 0.2);
  EXPECT_GT(layouts[0].room_share, layouts[1].room_share);
  for (std::size_t i = 2; i < layouts.size(); ++i) EXPECT_LT(layouts[i].kept_scale, layouts[i - 1].kept_scale);
  usual.chosen = false;
  EXPECT_TRUE(pipeline::roomier_layouts({}, usual).empty());
}

}  // namespace
}  // namespace epura::layouts_test
