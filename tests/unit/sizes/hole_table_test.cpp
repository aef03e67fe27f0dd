// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_table.hpp"

#include <gtest/gtest.h>

namespace epura::test::hole_table_test {
namespace {

TEST(HoleTable, Letters) {
  EXPECT_EQ(sheet::letters_of(0), "A");
  EXPECT_EQ(sheet::letters_of(8), "J") << "I looks like 1";
  EXPECT_EQ(sheet::letters_of(22), "Z");
  EXPECT_EQ(sheet::letters_of(23), "AA");
  EXPECT_EQ(sheet::letters_of(24), "AB");
}

TEST(HoleTable, Recesses) {
  features::HoleFeature hole{0, {0, 0, 0}, {0, 0, 1}, 8, false, 18.5};
  hole.counterbore = features::Recess{14, 5};
  EXPECT_EQ(sheet::recesses_of(hole, {}), " ↧18.5 ⌴⌀14 ↧5");
  hole.depth.reset();
  hole.counterbore.reset();
  hole.countersink = features::Recess{16, 90};
  EXPECT_EQ(sheet::recesses_of(hole, {}), " ⌵⌀16×90°");
}

// Row heights are 1.8 times the letters.
TEST(HoleTable, IsDrawnInBlocksOfRows) {
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  const sheet::HoleTable table{
      "top", {0, 0, 0}, {{"A1", "10", "20", "⌀8"}, {"A2", "30", "20", "⌀8"}, {"B1", "5", "5", "⌀4"}}};
  const std::vector<std::string> captions{"Hole", "X", "Y", "Size"};
  const sheet::TextTable texts = sheet::text_table(table, captions);
  const sheet::TableDrawing one(texts, 1, style), two(texts, 2, style);
  EXPECT_NEAR(one.size().y, 4 * 1.8 * 3.5, 1e-9);
  EXPECT_NEAR(two.size().y, 3 * 1.8 * 3.5, 1e-9);
  EXPECT_NEAR(two.size().x, 2 * one.size().x + 3.5, 1e-9);
  sheet::Layer layer;
  one.draw(layer, {100, 200}, "dimension");
  EXPECT_EQ(layer.texts.size(), 16U);
  for (const sheet::Text& text : layer.texts) {
    EXPECT_GT(text.at.x, 100 - one.size().x);
    EXPECT_LT(text.at.x + lettering.width(text.text, text.height), 100);
    EXPECT_GT(text.at.y, 200 - one.size().y);
    EXPECT_LT(text.at.y + text.height, 200);
  }
  sheet::Layer both;
  two.draw(both, {100, 200}, "dimension");
  EXPECT_EQ(both.texts.size(), 20U) << "the captions are repeated";
}

TEST(HoleTable, StandsInTheUpperRightOfTheFreeRoom) {
  const sheet::Rectangle room{{0, 0}, {200, 100}};
  const std::vector<sheet::Rectangle> taken{{{100, 40}, {200, 100}}};
  const auto corner = sheet::free_corner(room, taken, {50, 30});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->x, 97);  // 3 mm beside what is taken and inside the frame
  EXPECT_EQ(corner->y, 97);
  const auto wide = sheet::free_corner(room, taken, {150, 30});
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->x, 197);
  EXPECT_EQ(wide->y, 37);
  EXPECT_FALSE(sheet::free_corner(room, taken, {150, 50}));
}

}  // namespace
}  // namespace epura::test::hole_table_test
