// SPDX-License-Identifier: Apache-2.0
#include "annotations/revision_clouds.hpp"

#include <gtest/gtest.h>

#include "sheet/paper.hpp"

namespace epura::test::revision_clouds_test {
namespace {

using sheet::Rectangle;

Rectangle ink_of(const sheet::Layer& layer) {
  Rectangle box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const sheet::Stroke& stroke : layer.strokes)
    for (const Vec2& point : stroke.points) box = {glm::min(box.min, point), glm::max(box.max, point)};
  return box;
}

// Boxes along a line, some way from one to the next.
std::vector<Rectangle> row_of(int count, double gap) {
  constexpr double width = 10, height = 4;
  std::vector<Rectangle> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec2 low(i * (width + gap), 0);
    boxes.push_back({low, low + Vec2(width, height)});
  }
  return boxes;
}

// A cloud and the triangle beside it take 6 mm to the left of their ink, and 14 mm to the right.
TEST(RevisionClouds, AreOneWhereTheyWouldMeet) {
  EXPECT_EQ(sheet::united_changes(row_of(5, 19)).size(), 1U);
  EXPECT_EQ(sheet::united_changes(row_of(5, 21)).size(), 5U);
  EXPECT_TRUE(sheet::united_changes({}).empty());
}

TEST(RevisionClouds, HaveTheirTrianglesToThemselves) {
  const std::vector<Rectangle> boxes = sheet::united_changes(row_of(3, 21));
  ASSERT_EQ(boxes.size(), 3U);
  std::vector<Rectangle> ink;
  for (const Rectangle& box : boxes) ink.push_back(ink_of(sheet::revision_clouds({&box, 1}, "B", {})));
  for (std::size_t i = 1; i < ink.size(); ++i) EXPECT_LT(ink[i - 1].max.x, ink[i].min.x);
}

}  // namespace
}  // namespace epura::test::revision_clouds_test
