// SPDX-License-Identifier: Apache-2.0
#include "base/disjoint_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace epura::test::disjoint_sets_test {
namespace {

TEST(DisjointSets, BeginsWithEachNumberAlone) {
  EXPECT_EQ(DisjointSets(3).roots(), (std::vector{0, 1, 2}));
  EXPECT_TRUE(DisjointSets(0).roots().empty());
}

TEST(DisjointSets, KnowsASetByItsSmallestNumber) {
  DisjointSets sets(6);
  sets.join(5, 3);
  sets.join(4, 2);
  EXPECT_EQ(sets.root(5), 3);
  EXPECT_NE(sets.root(4), sets.root(3));
  sets.join(5, 4);
  EXPECT_EQ(sets.root(3), 2);
  EXPECT_EQ(std::move(sets).roots(), (std::vector{0, 1, 2, 2, 2, 2}));
}

TEST(DisjointSets, JoinsANumberWithItself) {
  DisjointSets sets(3);
  sets.join(2, 1);
  sets.join(2, 2);
  sets.join(1, 2);
  EXPECT_EQ(std::move(sets).roots(), (std::vector{0, 1, 1}));
}

// A chain from the back makes the longest paths.
TEST(DisjointSets, JoinsALongChain) {
  constexpr int count = 100000;
  DisjointSets sets(count);
  for (int i = count - 1; i > 0; --i) sets.join(i, i - 1);
  EXPECT_EQ(std::move(sets).roots(), std::vector<int>(count, 0));
}

// Beside labels that are all written again at each join.
TEST(DisjointSets, AgreesWithLabelsThatAreRewritten) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    constexpr int count = 60;
    std::vector<int> labels;
    for (int i = 0; i < count; ++i) labels.push_back(i);
    DisjointSets sets(count);
    for (int joins = 0; joins < round; ++joins) {
      const int i = static_cast<int>(random() % count), j = static_cast<int>(random() % count);
      sets.join(i, j);
      const auto [kept, gone] = std::minmax({labels[i], labels[j]});
      std::replace(labels.begin(), labels.end(), gone, kept);
      ASSERT_EQ(sets.root(j), labels[j]);
    }
    ASSERT_EQ(std::move(sets).roots(), labels);
  }
}

}  // namespace
}  // namespace epura::test::disjoint_sets_test
