// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "dimensions/costs.hpp"
#include "dimensions/obstacles.hpp"
#include "sheet/boxes.hpp"

namespace epura::test::conflicts_test {
namespace {

// Of thousands in one place, each pair would be named.
TEST(Conflicts, OfDimensionsInACrowdOnlySomeOthersAreNamed) {
  constexpr std::size_t count = 3 * sheet::max_in_crowd;
  sheet::PlacedDimension one;
  one.zones = {sheet::turned_box({{0, 0}, {10, 5}})};
  const sheet::PlacedDimensions placed(count, one);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) texts.push_back(std::to_string(i));
  const std::vector<std::string> named = sheet::crossings_of(placed, texts, {drawing::ViewDrawing(), {}});
  std::size_t expected = 0;
  for (std::size_t i = 0; i < count; ++i) expected += std::min(count - 1 - i, sheet::max_in_crowd + 1);
  EXPECT_EQ(named.size(), expected);
  EXPECT_EQ(named.at(sheet::max_in_crowd - 1), "'0' and '" + std::to_string(sheet::max_in_crowd) + "'");
  EXPECT_EQ(named.at(sheet::max_in_crowd), "'0' and more dimensions");
  EXPECT_EQ(named.back(), "'" + texts.at(count - 2) + "' and '" + texts.back() + "'");
}

}  // namespace
}  // namespace epura::test::conflicts_test
