// SPDX-License-Identifier: Apache-2.0
#include "base/groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/parallel.hpp"

namespace epura::groups_test {
namespace {

TEST(Groups, HoldEveryItemOnce) {
  constexpr std::size_t count = 100000, groups = 37;
  Groups<int> grouped(groups, [&](const auto& add) {
    parallel_for(count, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (i % groups != 5) add(i % groups, static_cast<int>(i));
    });
  });
  ASSERT_EQ(grouped.size(), groups);
  EXPECT_TRUE(grouped[5].empty());
  std::size_t found = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    std::sort(grouped[g].begin(), grouped[g].end());
    for (std::size_t i = 0; i < grouped[g].size(); ++i) EXPECT_EQ(grouped[g][i], g + i * groups);
    found += grouped[g].size();
  }
  EXPECT_EQ(found, count - count / groups - (count % groups > 5 ? 1 : 0));
  EXPECT_EQ(Groups<int>().size(), 0u);
}

TEST(Groups, KeepWhatIsCounted) {
  Groups<int> grouped(4, [](const auto& add) {
    for (int i = 0; i < 12; ++i) add(static_cast<std::size_t>(i % 3), i);
  });
  grouped.shorten([](std::size_t group, std::span<const int> items) { return std::min(group, items.size()); });
  const auto items = [&](std::size_t group) { return std::vector<int>(grouped[group].begin(), grouped[group].end()); };
  EXPECT_EQ(items(0), (std::vector<int>{}));
  EXPECT_EQ(items(1), (std::vector<int>{1}));
  EXPECT_EQ(items(2), (std::vector<int>{2, 5}));
  EXPECT_EQ(items(3), (std::vector<int>{}));
}

}  // namespace
}  // namespace epura::groups_test
