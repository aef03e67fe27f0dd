// SPDX-License-Identifier: Apache-2.0
#include "dimensions/obstacles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dimensions/costs.hpp"

namespace epura::test::obstacles_test {
namespace {

// A dimension with a line from (0, y) to (10, y) for each y.
sheet::PlacedDimension across(const std::vector<double>& heights) {
  sheet::PlacedDimension dimension;
  for (const double y : heights) dimension.lines.push_back(sheet::line_box({0, y}, {10, y}));
  return dimension;
}

// What costs as much as the best place so far is not cheaper: rounding must not make it so, hence its whole cost
// counts.
TEST(Obstacles, TiesAreComputedToTheirEnd) {
  sheet::Neighbours neighbours;
  for (const double x : {2.0, 4.0, 6.0}) {
    neighbours.boxes.push_back(sheet::turned_box({{x, 0}, {x + 1, 2}}));
    neighbours.views.push_back(sheet::turned_box({{x, 0}, {x + 1, 2}}));
  }
  const drawing::ViewDrawing nothing{};
  const sheet::Obstacles obstacles(nothing, neighbours);
  const sheet::PlacedDimension one = across({1}), two = across({1, 1.5});
  const double cost = obstacles.cost(one, HUGE_VAL);
  EXPECT_GT(cost, 3 * sheet::cost_of_zone);
  EXPECT_EQ(obstacles.cost(two, HUGE_VAL), 2 * cost);
  for (const double max : {cost, 3 * sheet::cost_of_zone, 2 * sheet::cost_of_zone, 0.1}) {
    EXPECT_GT(obstacles.cost(two, max), max);
    EXPECT_LE(obstacles.cost(two, max), 2 * cost);
  }
  EXPECT_EQ(obstacles.cost(one, cost), cost);
}

}  // namespace
}  // namespace epura::test::obstacles_test
