// SPDX-License-Identifier: Apache-2.0
#include "search/bounds_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace epura::test::bounds_tree_test {
namespace {

using Tree = search::BoundsTree<1>;

// Item i is the interval from i to i + 1/2.
Tree intervals(std::size_t count) {
  return {count, [](std::size_t i) { return search::Bounds<1>{{{double(i), double(i) + 0.5}}}; }};
}

std::vector<std::size_t> visited(const Tree& tree, double from, double to, std::size_t most = 1000) {
  std::vector<std::size_t> items;
  tree.visit({{{from, to}}}, [&](std::size_t i) {
    items.push_back(i);
    return items.size() < most;
  });
  return items;
}

TEST(BoundsTree, VisitsAllThatMeetTheBoundsInOrder) {
  for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 100U}) {
    const Tree tree = intervals(count);
    EXPECT_FALSE(tree.empty());
    const std::vector<std::size_t> all = visited(tree, 0, 1000);
    ASSERT_EQ(all.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(all[i], i);
      const std::vector<std::size_t> near = visited(tree, double(i) + 0.5, double(i) + 0.5);
      EXPECT_TRUE(std::find(near.begin(), near.end(), i) != near.end()) << i << " of " << count;
    }
    EXPECT_TRUE(visited(tree, -2, -1).empty());
  }
  EXPECT_TRUE(Tree().empty());
}

TEST(BoundsTree, EndsWhenTold) { EXPECT_EQ(visited(intervals(100), 0, 1000, 20).size(), 20U); }

}  // namespace
}  // namespace epura::test::bounds_tree_test
