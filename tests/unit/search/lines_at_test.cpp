// SPDX-License-Identifier: Apache-2.0
#include "search/lines_at.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "base/nearest.hpp"

namespace epura::test::lines_at_test {
namespace {

using search::LinesAt;

// Lines of all lengths, some of them points; places on them, beside them, and far away.
TEST(LinesAt, FindsAllThatPassWithinTheMargin) {
  std::mt19937 random(5);
  const auto number = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  for (const double margin : {1e-9, 1e-3, 2.0}) {
    std::vector<LinesAt::Line> lines;
    for (int i = 0; i < 500; ++i) {
      const Vec2 from(number(-50, 150), number(0, 30));
      lines.push_back(
          {from, from + std::pow(10.0, number(-6, 2)) * Vec2(number(-1, 1), i % 7 == 0 ? 0 : number(-1, 1))});
    }
    lines.push_back({Vec2(20, 10), Vec2(20, 10)});
    const LinesAt lines_at(lines, margin);
    std::size_t found = 0, all = 0;
    for (const auto& [from, to] : lines) {
      const Vec2 step = to - from;
      for (const Vec2& place :
           {from, to, from + number(0, 1) * step, from + Vec2(number(-1, 1), number(-1, 1)) * margin,
            Vec2(number(-1e3, 1e3), number(-1e3, 1e3))}) {
        const auto numbers = lines_at(place);
        EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
        for (int k = 0; k < static_cast<int>(lines.size()); ++k)
          if (glm::distance(nearest_on_segment(place, lines[k][0], lines[k][1]), place) <= margin) {
            EXPECT_TRUE(std::binary_search(numbers.begin(), numbers.end(), k)) << k << ", margin " << margin;
          }
        found += numbers.size();
        all += lines.size();
      }
    }
    if (margin < 1) {
      EXPECT_LT(found, all / 10) << "nearly all lines are left out";
    }
  }
}

TEST(LinesAt, FindsNothingAmongNoLines) { EXPECT_TRUE(LinesAt({}, 1)(Vec2(3, 4)).empty()); }

}  // namespace
}  // namespace epura::test::lines_at_test
