// SPDX-License-Identifier: Apache-2.0
#include "sheet/crossings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace epura::crossings_test {
namespace {

drawing::Chain line(std::vector<Vec2> points, bool closed = false, bool visible = true) {
  return {std::move(points), closed, visible, EdgeKind::crease, {0}};
}

// Of all chains.
sheet::Crossings all_crossings(const std::vector<drawing::Chain>& chains) {
  std::vector<std::size_t> all(chains.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {chains, all};
}

TEST(Crossings, AreDistancesAlongTheChain) {
  const std::vector<drawing::Chain> chains = {line({{0, 0}, {10, 0}, {10, 10}}), line({{4, -5}, {4, 5}}),
                                              line({{8, 6}, {12, 6}}), line({{7, 0}, {7, 3}}), line({{0, 1}, {3, 1}})};
  const sheet::Crossings crossings = all_crossings(chains);
  EXPECT_EQ(crossings.along(0, 0.1), (std::vector<double>{4, 7, 16}));  // crossed, ended on, crossed behind the corner
  EXPECT_EQ(crossings.along(1, 0.1), (std::vector<double>{5}));
  EXPECT_EQ(crossings.along(4, 0.1), (std::vector<double>{}));
}

TEST(Crossings, NearOnesCountOnceAndParallelLinesDoNot) {
  const std::vector<drawing::Chain> chains = {line({{0, 0}, {10, 0}}), line({{4, -1}, {4, 1}}),
                                              line({{4.05, -1}, {4.05, 1}}), line({{2, 0}, {6, 0}})};
  EXPECT_EQ(all_crossings(chains).along(0, 0.1), (std::vector<double>{4}));
}

TEST(Crossings, OutlinesAreVisibleAndNotSmooth) {
  std::vector<drawing::Chain> chains = {line({{0, 0}, {10, 0}}), line({{0, 5}, {10, 5}}, false, false)};
  chains.push_back(line({{0, 8}, {10, 8}}));
  chains.back().kind = EdgeKind::smooth;
  const sheet::Crossings crossings = all_crossings(chains);
  EXPECT_TRUE(crossings.has_outline_at({3, 0}));
  EXPECT_FALSE(crossings.has_outline_at({3, 0.1}));
  EXPECT_FALSE(crossings.has_outline_at({3, 5}));
  EXPECT_FALSE(crossings.has_outline_at({3, 8}));
}

// The grid leaves nothing out: all pairs, one by one, find the same.
TEST(Crossings, AreThoseOfAllPairs) {
  std::mt19937 random(3);
  const auto point = [&random] { return Vec2(random() % 1000, random() % 1000) / 7.0; };
  std::vector<drawing::Chain> chains;
  for (int i = 0; i < 300; ++i) {
    const Vec2 from = point();
    const Vec2 to = i % 3 == 0 ? Vec2(from.x, point().y) : i % 3 == 1 ? from + point() / 20.0 : point();
    chains.push_back(line({from, to}));
  }
  const sheet::Crossings crossings = all_crossings(chains);
  std::size_t found = 0;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    std::vector<double> pairs;
    for (std::size_t j = 0; j < chains.size(); ++j)
      if (const std::vector<drawing::Chain> two = {chains[i], chains[j]}; j != i)
        for (const double at : all_crossings(two).along(0, 1e-9)) pairs.push_back(at);
    std::sort(pairs.begin(), pairs.end());
    const auto near = [](double a, double b) { return b - a < 1e-9; };
    pairs.erase(std::unique(pairs.begin(), pairs.end(), near), pairs.end());
    EXPECT_EQ(crossings.along(i, 1e-9).size(), pairs.size()) << i;
    found += pairs.size();
  }
  EXPECT_GT(found, 3000u);
}

}  // namespace
}  // namespace epura::crossings_test
