// SPDX-License-Identifier: Apache-2.0
// Where the radius of a rounded edge is measured if slots have left parts of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dimensions_support.hpp"
#include "sizes/radius_dimensions.hpp"

namespace epura::test::rounded_edges_test {
namespace {

std::vector<sheet::NamedProjection> views_of(const std::vector<std::pair<std::string, Vec3>>& sights) {
  std::vector<sheet::NamedProjection> views;
  for (const auto& [name, sight] : sights) views.push_back({name, orthographic(sight)});
  return views;
}

// Around the z axis: the middle of its section is 10 from the axis, and two parts face the ends of the y axis.
features::RoundFeature slotted(double half) {
  return {0, {0, 0, 5}, {0, 0, 1}, 10, 2, {0, 90}, {{{0, 1, 0}, half}, {{0, -1, 0}, half}}};
}

TEST(RoundedEdges, AreMeasuredWhereTheOutlineIsTheirSection) {
  const auto views = views_of({{"front", from_front}, {"left", from_left}});
  const scene::DimensionDescription wanted;
  const auto seen = sheet::seen_section(slotted(80), {wanted, views});
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(seen->view->name, "left");
  EXPECT_NEAR(std::abs(seen->circle.centre.y), 10, 1e-12);
  EXPECT_NEAR(std::abs(seen->circle.arc.front().y), 12, 1e-12);
}

// At the wall of a slot 10 degrees wide to either side, the edge is 12 cos 10 from the axis.
TEST(RoundedEdges, BesideASlotAreMeasuredAtItsWall) {
  const auto views = views_of({{"front", from_front}});
  const scene::DimensionDescription wanted;
  const auto seen = sheet::seen_section(slotted(80), {wanted, views});
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(seen->view->name, "front");
  EXPECT_EQ(seen->circle.radius, 2);
  EXPECT_NEAR(std::abs(seen->circle.arc.front().x), 12 * std::cos(10 * std::numbers::pi / 180), 1e-12);
  EXPECT_FALSE(sheet::seen_section(slotted(70), {wanted, views}).has_value());
}

}  // namespace
}  // namespace epura::test::rounded_edges_test
