// SPDX-License-Identifier: Apache-2.0
#include "base/same_key.hpp"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <random>

namespace epura::test::same_key_test {
namespace {

using Groups = std::vector<std::vector<int>>;

TEST(SameKeys, AreThoseThatAMapFinds) {
  std::mt19937 random(4);
  std::vector<std::array<double, 2>> keys(50000);
  for (auto& key : keys) key = {static_cast<double>(random() % 300) / 7, static_cast<double>(random() % 100) * 1e-9};
  std::map<std::array<double, 2>, std::vector<int>> expected;
  for (int i = 0; i < 50000; ++i) expected[keys[i]].push_back(i);
  std::erase_if(expected, [](const auto& entry) { return entry.second.size() < 2; });

  std::mutex adding;
  Groups found;
  visit_same_keys(
      50000, [&](int i) { return keys[i]; }, Progress(),
      [&](std::span<const int> items) {
        const std::lock_guard lock(adding);
        found.emplace_back(items.begin(), items.end());
      });
  ASSERT_EQ(found.size(), expected.size());
  for (const std::vector<int>& items : found) EXPECT_EQ(items, expected.at(keys[items[0]]));
}

TEST(SameKeys, ZerosAreEqual) {
  int found = 0;
  visit_same_keys(
      3,
      [](int i) {
        return std::array{i == 1 ? -0.0 : 0.0, i == 2 ? 1.0 : 0.0};
      },
      Progress(),
      [&](std::span<const int> items) {
        EXPECT_EQ(std::vector<int>(items.begin(), items.end()), (std::vector<int>{0, 1}));
        ++found;
      });
  EXPECT_EQ(found, 1);
}

TEST(SameKeys, OfOneHashAreToldApart) {
  std::vector<int> items{0, 1, 2, 3, 4, 5, 6};
  Groups found;
  visit_same_hash(
      items, [](int i) { return std::array{i == 6       ? 7.0
                                           : i % 2 == 0 ? 1.0
                                                        : 0.0}; },
      [&](std::span<const int> same) { found.emplace_back(same.begin(), same.end()); });
  EXPECT_EQ(found, (Groups{{1, 3, 5}, {0, 2, 4}}));
}

TEST(SameKeys, ThirdCopiesHaveTwoBeforeThem) {
  const std::vector<double> keys{1, 2, 1, 2, 1, 3, 1};
  EXPECT_EQ(mark_third_copies(
                7, [&](int i) { return std::array{keys[i]}; }, Progress()),
            (std::vector<char>{0, 0, 0, 0, 1, 0, 1}));
}

}  // namespace
}  // namespace epura::test::same_key_test
