// SPDX-License-Identifier: Apache-2.0
#include "dimensions/surroundings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dimensions/costs.hpp"

namespace epura::test::surroundings_test {
namespace {

// A dimension with a line from (0, y) to (10, y) for each y.
sheet::PlacedDimension across(const std::vector<double>& heights) {
  sheet::PlacedDimension dimension;
  for (const double y : heights) dimension.lines.push_back(sheet::line_box({0, y}, {10, y}));
  return dimension;
}

// What costs as much as the best place so far is not cheaper: rounding must not make it so, hence its whole cost
// counts.
TEST(Surroundings, TiesAreComputedToTheirEnd) {
  sheet::Neighbours neighbours;
  for (const double x : {2.0, 4.0, 6.0}) {
    neighbours.boxes.push_back(sheet::turned_box({{x, 0}, {x + 1, 2}}));
    neighbours.views.push_back(sheet::turned_box({{x, 0}, {x + 1, 2}}));
  }
  const drawing::ViewDrawing nothing{};
  const sheet::Surroundings surroundings(nothing, neighbours);
  const sheet::PlacedDimension one = across({1}), two = across({1, 1.5});
  const double cost = surroundings.cost(one, HUGE_VAL);
  EXPECT_GT(cost, 3 * sheet::cost_of_zone);
  EXPECT_EQ(surroundings.cost(two, HUGE_VAL), 2 * cost);
  for (const double max : {cost, 3 * sheet::cost_of_zone, 2 * sheet::cost_of_zone, 0.1}) {
    EXPECT_GT(surroundings.cost(two, max), max);
    EXPECT_LE(surroundings.cost(two, max), 2 * cost);
  }
  EXPECT_EQ(surroundings.cost(one, cost), cost);
}

}  // namespace
}  // namespace epura::test::surroundings_test
