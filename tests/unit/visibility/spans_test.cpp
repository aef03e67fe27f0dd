// SPDX-License-Identifier: Apache-2.0
#include "visibility/spans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace epura::test::spans_test {
namespace {

visibility::Spans sum(const std::vector<std::array<double, 2>>& parts) {
  visibility::Spans spans;
  for (const auto& part : parts) visibility::add_span(spans, part);
  return spans;
}

TEST(Spans, TouchingOnesBecomeOne) {
  EXPECT_EQ(sum({{0.1, 0.2}, {0.3, 0.4}}), (visibility::Spans{{0.1, 0.2}, {0.3, 0.4}}));
  EXPECT_EQ(sum({{0.3, 0.4}, {0.1, 0.3}}), (visibility::Spans{{0.1, 0.4}}));
  EXPECT_EQ(sum({{0.1, 0.2}, {0.5, 0.6}, {0.8, 0.9}, {0.15, 0.8}}), (visibility::Spans{{0.1, 0.9}}));
  EXPECT_EQ(sum({{0, 1}, {0.4, 0.5}}), (visibility::Spans{{0, 1}}));
}

TEST(Spans, AreTheUnionInAnyOrder) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::array<double, 2>> parts;
    for (int i = 0; i < 12; ++i) {
      const double a = static_cast<double>(random() % 60) / 64;
      parts.push_back({a, a + static_cast<double>(1 + random() % 4) / 64});
    }
    const visibility::Spans spans = sum(parts);
    std::shuffle(parts.begin(), parts.end(), random);
    ASSERT_EQ(sum(parts), spans);
    for (std::size_t i = 1; i < spans.size(); ++i) ASSERT_LT(spans[i - 1][1], spans[i][0]);
    for (int k = 0; k < 64; ++k) {
      const double t = (k + 0.5) / 64;
      const bool inside = std::any_of(parts.begin(), parts.end(), [&](const auto& p) { return p[0] < t && t < p[1]; });
      ASSERT_EQ(visibility::covers(spans, t, t), inside) << t;
    }
  }
}

TEST(Spans, OneHasToCoverTheWhole) {
  const visibility::Spans spans{{0.1, 0.4}, {0.5, 0.9}};
  EXPECT_TRUE(visibility::covers(spans, 0.1, 0.4));
  EXPECT_TRUE(visibility::covers(spans, 0.6, 0.7));
  EXPECT_FALSE(visibility::covers(spans, 0.3, 0.6));
  EXPECT_FALSE(visibility::covers(spans, 0.0, 0.2));
  EXPECT_FALSE(visibility::covers(spans, 0.85, 0.95));
  EXPECT_FALSE(visibility::covers({}, 0, 0));
}

TEST(Spans, WhatIsOpenIsWhatFurtherOnesMayChange) {
  const auto open = [](const visibility::Spans& spans, double from, double to) {
    return visibility::open_part(spans, from, to, 0.001).value_or(std::array{-1.0, -1.0});
  };
  const std::array none{-1.0, -1.0};
  EXPECT_EQ(open({}, 0.2, 0.4), (std::array{0.2, 0.4}));
  EXPECT_EQ(open({{0.1, 0.4}, {0.5, 0.9}}, 0.2, 0.7), (std::array{0.4, 0.5}));
  EXPECT_EQ(open({{0.1, 0.4}, {0.5, 0.9}}, 0.0, 1.0), (std::array{0.0, 1.0}));
  EXPECT_EQ(open({{0.1, 0.4}, {0.5, 0.9}}, 0.15, 0.95), (std::array{0.4, 0.95}));
  EXPECT_EQ(open({{0.1, 0.4}, {0.5, 0.9}}, 0.1, 0.4), none);
  EXPECT_EQ(open({{0.1, 0.4}, {0.4005, 0.9}}, 0.2, 0.8), none) << "a sliver between two";
  EXPECT_EQ(open({{0.0005, 0.9995}}, 0.0, 1.0), none) << "slivers at the ends";
  EXPECT_EQ(open({{0.3995, 0.4}, {0.4005, 0.401}}, 0.3996, 0.4009), (std::array{0.4, 0.4005})) << "both may go";
  EXPECT_EQ(visibility::open_part({{0.1, 2.9995}}, 1, 3, 0.001, 3), std::nullopt);
}

TEST(Spans, WhatIsNotOpenCanHoldMoreAndStaysTheSame) {
  std::mt19937 random(2);
  const auto part = [&](double longest) {
    const double from = static_cast<double>(random() % 1000) / 1000;
    return std::array{from, std::min(1.0, from + longest * static_cast<double>(1 + random() % 1000) / 1000)};
  };
  int closed = 0;
  for (int round = 0; round < 20000; ++round) {
    constexpr double min = 0.1;
    visibility::Spans spans;
    for (int i = 0; i < 6; ++i) visibility::add_span(spans, part(0.4));
    const auto more = part(0.1);
    if (visibility::open_part(spans, more[0], more[1], min)) continue;
    ++closed;
    visibility::Spans all = spans;
    visibility::add_span(all, more);
    visibility::absorb_slivers(spans, min);
    visibility::absorb_slivers(all, min);
    ASSERT_EQ(all, spans);
  }
  EXPECT_GT(closed, 1000);
}

visibility::Spans absorbed(visibility::Spans spans, double min) {
  visibility::absorb_slivers(spans, min);
  return spans;
}

TEST(Slivers, GapsAreClosedThenSpansDropped) {
  EXPECT_EQ(absorbed({{0.1, 0.4}, {0.4005, 0.8}}, 0.001), (visibility::Spans{{0.1, 0.8}}));
  EXPECT_EQ(absorbed({{0.1, 0.4}, {0.402, 0.8}}, 0.001), (visibility::Spans{{0.1, 0.4}, {0.402, 0.8}}));
  EXPECT_EQ(absorbed({{0.2, 0.2005}, {0.4, 0.8}}, 0.001), (visibility::Spans{{0.4, 0.8}}));
  // Three short ones close together are one long one.
  EXPECT_EQ(absorbed({{0.2, 0.2009}, {0.201, 0.2018}, {0.202, 0.203}}, 0.001), (visibility::Spans{{0.2, 0.203}}));
  EXPECT_EQ(absorbed({{0.0005, 0.5}, {0.7, 0.9995}}, 0.001), (visibility::Spans{{0, 0.5}, {0.7, 1}}));
  EXPECT_TRUE(absorbed({{0.5, 0.5001}}, 0.001).empty());
}

TEST(Slivers, AShortEdgeIsWhollyOneOrTheOther) {
  EXPECT_EQ(absorbed({{0.1, 0.4}, {0.5, 0.8}}, 2), (visibility::Spans{{0, 1}}));
  EXPECT_TRUE(absorbed({{0.1, 0.4}}, 2).empty());
  EXPECT_TRUE(absorbed({}, 2).empty());
}

}  // namespace
}  // namespace epura::test::spans_test
