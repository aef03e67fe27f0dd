#include "base/groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/parallel.hpp"

namespace epura {
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

}  // namespace
}  // namespace epura
