// SPDX-License-Identifier: Apache-2.0
#include "drawing/ink_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "drawing/kept_ink.hpp"

namespace epura::test::ink_cells_test {
namespace {

using Line = std::array<Vec2, 2>;

// An end of one of two lines that do not cross is nearest to the other.
bool are_near(const Line& a, const Line& b, double margin) {
  for (const auto& [line, other] : {std::pair(a, b), std::pair(b, a)})
    for (const Vec2& end : line)
      if (glm::distance(drawing::nearest_on(other, end), end) <= margin) return true;
  const auto side = [](const Line& line, const Vec2& p) {
    const Vec2 step = line[1] - line[0], d = p - line[0];
    return cross(step, d) > 0;
  };
  return side(a, b[0]) != side(a, b[1]) && side(b, a[0]) != side(b, a[1]);
}

// Lines of all lengths come one by one, and each time all that are near are found.
TEST(InkCells, FindAllThatIsNear) {
  std::mt19937 random(3);
  const auto number = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  for (const double least : {0.01, 1.0, 300.0}) {
    std::vector<Line> lines;
    drawing::InkCells cells({0, 0}, {200, 100}, least);
    for (int i = 0; i < 400; ++i) {
      const Vec2 from(number(0, 200), number(0, 100));
      const double angle = number(0, 7), length = std::pow(10.0, number(-3, 2));
      const Line line{from,
                      glm::clamp(from + length * Vec2(std::cos(angle), std::sin(angle)), Vec2(0), Vec2(200, 100))};
      const double margin = std::pow(10.0, number(-2, 0.5));
      const std::vector<int> found = cells.find(line[0], line[1], margin);
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end(), std::greater_equal()), found.end()) << "not ascending";
      for (int k = 0; k < i; ++k)
        if (are_near(line, lines[static_cast<std::size_t>(k)], margin)) {
          EXPECT_TRUE(std::binary_search(found.begin(), found.end(), k)) << i << ", " << k;
        }
      cells.add(line[0], line[1]);
      lines.push_back(line);
    }
  }
}

TEST(InkCells, FindThoseOfSomeDirections) {
  drawing::InkCells cells({0, 0}, {1, 1}, 0.1);
  EXPECT_TRUE(cells.empty());
  for (int i = 0; i < 20; ++i) cells.add({0.5, 0.5}, {0.52, 0.5}, i % 2);
  EXPECT_FALSE(cells.empty());
  EXPECT_EQ(cells.find({0.4, 0.5}, {0.6, 0.5}, 0.2).size(), 20U);
  const std::vector<int> odd = cells.find({0.4, 0.5}, {0.6, 0.5}, 0.2, 2);
  EXPECT_EQ(odd.size(), 10U);
  EXPECT_TRUE(std::all_of(odd.begin(), odd.end(), [](int number) { return number % 2 == 1; }));
}

}  // namespace
}  // namespace epura::test::ink_cells_test
