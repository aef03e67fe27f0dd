// SPDX-License-Identifier: Apache-2.0
#include "sheet/box_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace epura::test::box_index_test {
namespace {

// Small and long boxes and lines in all directions, on the paper and far off it, some of them again and again.
std::vector<sheet::TurnedBox> boxes(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<sheet::TurnedBox> boxes;
  for (int i = 0; i < count; ++i) {
    if (i > 0 && random() % 4 == 0) {
      boxes.push_back(boxes[random() % boxes.size()]);
      continue;
    }
    const double angle = random() % 2 == 0 ? 0 : uniform(-4, 4), reach = random() % 8 == 0 ? 1e5 : 200;
    boxes.push_back({{uniform(-reach, reach), uniform(-reach, reach)},
                     {std::cos(angle), std::sin(angle)},
                     {std::pow(10, uniform(-1, 3)), random() % 3 == 0 ? 0 : uniform(0, 20)}});
  }
  return boxes;
}

TEST(BoxIndex, CountsWhatOverlapsAmongAll) {
  const std::vector<sheet::TurnedBox> all = boxes(500, 1);
  const sheet::BoxIndex index(all);
  int max = 0;
  for (const sheet::TurnedBox& box : boxes(300, 2)) {
    const auto meets = [&](const sheet::TurnedBox& other) { return sheet::overlap(box, other); };
    const auto expected = static_cast<int>(std::count_if(all.begin(), all.end(), meets));
    EXPECT_EQ(index.overlaps(box), expected);
    EXPECT_EQ(index.overlaps(box, expected), expected);
    const int fewer = expected / 2;
    EXPECT_TRUE(fewer == expected || index.overlaps(box, fewer) > fewer);
    max = std::max(max, expected);
  }
  EXPECT_GT(max, 50);
  EXPECT_EQ(sheet::BoxIndex().overlaps(all.front()), 0);
}

TEST(BoxIndex, FindsLinesBesideOthers) {
  const sheet::BoxIndex lines(std::vector<sheet::TurnedBox>{
      sheet::line_box({0, 0}, {100, 0}), sheet::line_box({0, 0.5}, {100, 0.5}), sheet::line_box({40, -9}, {40, 9}),
      sheet::line_box({90, 0.3}, {200, 0.3}), sheet::turned_box({{0, 0}, {100, 0.4}})});
  const auto counts = [&](const Vec2& from, const Vec2& to) {
    const sheet::BoxIndex::LinesBeside found = lines.beside(sheet::line_box(from, to), 0.1, 0.7);
    return std::pair(found.on_it, found.near);
  };
  EXPECT_EQ(counts({10, 0}, {50, 0}), std::pair(1, 1)) << "neither the line across nor the box";
  EXPECT_EQ(counts({50, 0}, {10, 0}), std::pair(1, 1));
  EXPECT_EQ(counts({80, 0.02}, {95, 0.02}), std::pair(1, 2));
  EXPECT_EQ(counts({10, 1.3}, {50, 1.3}), std::pair(0, 0));
  EXPECT_EQ(counts({100.5, 0}, {150, 0}), std::pair(0, 1)) << "only beside the one that goes on";
  EXPECT_EQ(counts({10, 0}, {50, 20}), std::pair(0, 0)) << "not parallel";
}

TEST(BoxIndex, CountsNoFurtherThanIsAsked) {
  const std::vector<sheet::TurnedBox> all(1, boxes(1, 1).front());
  sheet::BoxIndex index(all);
  for (int i = 0; i < 9; ++i) {
    index.add(all);
    sheet::TurnedBox moved = all.front();
    moved.centre += Vec2(1e-3 * (i + 1));
    index.add({&moved, 1});
  }
  EXPECT_EQ(index.overlaps(all.front()), 19);
  EXPECT_EQ(index.overlaps(all.front(), 3), 10);
  EXPECT_EQ(index.overlaps(all.front(), 10), 11);
}

TEST(BoxIndex, ForgetsWhatIsTakenOut) {
  const std::vector<sheet::TurnedBox> kept = boxes(200, 3), others = boxes(200, 4);
  sheet::BoxIndex index(kept);
  index.add(others);
  index.add(kept);
  index.remove(others);
  index.remove(kept);
  const sheet::BoxIndex expected(kept);
  for (const sheet::TurnedBox& box : boxes(300, 2)) EXPECT_EQ(index.overlaps(box), expected.overlaps(box));
}

}  // namespace
}  // namespace epura::test::box_index_test
