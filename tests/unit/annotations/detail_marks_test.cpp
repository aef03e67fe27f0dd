// SPDX-License-Identifier: Apache-2.0
#include "annotations/detail_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sheet/furniture.hpp"

namespace epura::test::detail_marks_test {
namespace {

constexpr sheet::LineWidths widths{0.5, 0.25};
const sheet::Rectangle page{{0, 0}, {200, 100}};

sheet::Layer wall(const Vec2& from, const Vec2& to) {
  sheet::Layer layer;
  layer.strokes.push_back(sheet::line(from, to));
  return layer;
}

sheet::DetailMark circle(const std::string& name, const Vec2& centre, double radius) {
  return {name, {centre, Vec2(radius), true}};
}

TEST(DetailMarks, LettersAreNextToTheirCirclesOnFreePaper) {
  const std::vector<sheet::DetailMark> marks{circle("X", {60, 50}, 10)};
  const sheet::Lettering lettering;
  const sheet::Layer layer = sheet::detail_marks("front", marks, {page, {}}, lettering, widths);
  EXPECT_EQ(layer.name, "front/detail");
  EXPECT_EQ(layer.style.width, 0.25);
  ASSERT_EQ(layer.strokes.size(), 1U);
  for (const Vec2& p : layer.strokes[0].points) EXPECT_NEAR(glm::distance(p, {60, 50}), 10, 1e-12);
  ASSERT_EQ(layer.strokes[0].curves.size(), 1U);
  ASSERT_EQ(layer.texts.size(), 1U);
  EXPECT_EQ(layer.texts[0].text, "X");
  EXPECT_EQ(layer.texts[0].height, 5);
  const sheet::TurnedBox box = sheet::box_of(layer.texts[0], lettering);
  const double apart = glm::length(glm::max(glm::abs(box.centre - Vec2(60, 50)) - box.half, Vec2(0))) - 10;
  EXPECT_GE(apart, 1 - 1e-9);
  EXPECT_LE(apart, 3);
}

// Lines all around the circle push the letter outwards, at the end of a leader.
TEST(DetailMarks, LettersAvoidInkAndEachOther) {
  const std::vector<sheet::DetailMark> marks{circle("X", {60, 50}, 10), circle("Y", {75, 50}, 4)};
  std::vector<sheet::Layer> drawn;
  for (double y = 30; y <= 70; y += 3) drawn.push_back(wall({40, y}, {90, y}));
  const sheet::Lettering lettering;
  const sheet::Layer layer = sheet::detail_marks("front", marks, {page, drawn}, lettering, widths);
  ASSERT_EQ(layer.texts.size(), 2U);
  ASSERT_EQ(layer.strokes.size(), 4U);  // with two leaders
  const sheet::TurnedBox x = sheet::box_of(layer.texts[0], lettering), y = sheet::box_of(layer.texts[1], lettering);
  EXPECT_FALSE(sheet::overlap(x, y));
  for (const sheet::TurnedBox& letter : {x, y}) {
    EXPECT_TRUE(page.holds(sheet::around(letter)));
    for (const sheet::Layer& line : drawn)
      for (const sheet::TurnedBox& box : sheet::boxes_of(line, lettering)) EXPECT_FALSE(sheet::overlap(letter, box));
  }
  // Leaders begin on the boundaries and point to the letters.
  for (const std::size_t i : {0U, 1U}) {
    const sheet::Stroke& leader = layer.strokes[i];
    EXPECT_NEAR(glm::distance(leader.points[0], marks[i].boundary.centre), marks[i].boundary.half.x, 1e-12);
    EXPECT_LT(glm::distance(leader.points[1], (i == 0 ? x : y).centre), 6);
  }
}

TEST(DetailMarks, RectanglesAreOutlines) {
  const std::vector<sheet::DetailMark> marks{{"Y", {{60, 50}, {10, 5}, false}}};
  const sheet::Layer layer = sheet::detail_marks("top", marks, {page, {}}, sheet::Lettering(), widths);
  ASSERT_EQ(layer.strokes.size(), 1U);
  EXPECT_TRUE(layer.strokes[0].closed);
  for (const Vec2& p : layer.strokes[0].points) EXPECT_EQ(glm::abs(p - Vec2(60, 50)), Vec2(10, 5));
}

}  // namespace
}  // namespace epura::test::detail_marks_test
