// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: texts across the lines of tables and lists, lists on each other.
#include "sheet/table_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sheet/list_table.hpp"
#include "sheet/revision_list.hpp"
#include "sheet/sheet_layers.hpp"

namespace epura::test::table_drawing_test {
namespace {

// Texts keep off all lines of the table.
void expect_clear(const sheet::Layer& layer, const sheet::Lettering& lettering) {
  for (const sheet::Text& text : layer.texts)
    for (const sheet::Stroke& stroke : layer.strokes)
      for (std::size_t i = 1; i < stroke.points.size(); ++i)
        EXPECT_FALSE(overlap(sheet::box_of(text, lettering), sheet::line_box(stroke.points[i - 1], stroke.points[i])))
            << text.text;
}

TEST(TableDrawing, HasATitleAHeaderAndRows) {
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  const sheet::TextTable table{"A title that is longer than both columns", {"a", "b"}, {{"1", "2"}, {"3", ""}}};
  const sheet::TableDrawing drawing(table, 1, style);
  EXPECT_NEAR(drawing.size().y, 4 * 1.8 * 3.5, 1e-9);
  EXPECT_GE(drawing.size().x, lettering.width(table.title, 3.5));
  sheet::Layer layer;
  drawing.draw(layer, {200, 100}, "table");
  std::vector<std::string> texts;
  for (const sheet::Text& text : layer.texts) {
    texts.push_back(text.text);
    EXPECT_EQ(text.role, "table");
    const sheet::Rectangle whole{Vec2(200, 100) - drawing.size(), {200, 100}};
    EXPECT_TRUE(whole.holds(sheet::around(sheet::box_of(text, lettering)))) << text.text;
  }
  EXPECT_EQ(texts, (std::vector<std::string>{table.title, "a", "b", "1", "2", "3"}));
  expect_clear(layer, lettering);
}

TEST(TableDrawing, MayHaveOneRowAndNothingElse) {
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  const sheet::TableDrawing drawing({{}, {}, {{"Module", "2"}}}, 1, style);
  EXPECT_NEAR(drawing.size().y, 1.8 * 3.5, 1e-9);
  sheet::Layer layer;
  drawing.draw(layer, {200, 100}, "table");
  EXPECT_EQ(layer.texts.size(), 2U);
  EXPECT_EQ(layer.strokes.size(), 5U) << "three upright lines, two level ones";
}

TEST(RevisionList, StandsOnTheListsBelow) {
  const sheet::Lettering lettering;
  scene::RevisionDescription first, second;
  first.revision = {"B", ""};
  first.text = {"bore larger", ""};
  second.revision = {"C", ""};
  second.text = {"material", ""};
  second.date = {"2026-09-14", ""};
  sheet::SheetFurniture furniture{{420, 297, 20, 10}};
  furniture.parts_list = sheet::PartsList{{world::Item{"plate", 1}}};
  furniture.revisions = sheet::RevisionList{{first, second}, "en"};
  const sheet::BlockBoxes boxes = sheet::block_boxes(furniture);
  ASSERT_TRUE(boxes.parts_list && boxes.revisions && boxes.all);
  EXPECT_FALSE(boxes.title_block);
  EXPECT_EQ(boxes.parts_list->min, Vec2(230, 10)) << "in the lower right corner, 180 mm wide";
  EXPECT_EQ(boxes.revisions->min, Vec2(230, boxes.parts_list->max.y));
  EXPECT_NEAR(boxes.revisions->size().y, 3 * 6, 1e-9);
  EXPECT_EQ(boxes.all->max, boxes.revisions->max);
  sheet::Layer layer;
  EXPECT_TRUE(sheet::draw_revisions(layer, *furniture.revisions, *boxes.revisions, lettering).empty());
  std::vector<std::string> texts;
  for (const sheet::Text& text : layer.texts) texts.push_back(text.text);
  EXPECT_EQ(texts,
            (std::vector<std::string>{"Rev.", "Change", "Date", "B", "bore larger", "C", "material", "2026-09-14"}))
      << "no author, no column";
  expect_clear(layer, lettering);
}

}  // namespace
}  // namespace epura::test::table_drawing_test
