// SPDX-License-Identifier: Apache-2.0
// What readers stumble over on a finished sheet, each planted alone.
#include "composition/legibility.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace epura::test::legibility_test {
namespace {

sheet::Layer layer_of(const std::string& view, const std::string& style) {
  return {view + "/" + style, {style, 0.25}, {}};
}

sheet::Stroke line(const std::vector<Vec2>& points) { return {points}; }

// A length from `from` to `to`, whose line is 10 above.
sheet::DimensionObject length(const Vec2& from, const Vec2& to, const std::string& text, std::size_t stroke) {
  sheet::DimensionObject object{sheet::DimensionShape::linear, {from, to, to + Vec2(0, 10)}};
  object.text = text;
  object.strokes = {stroke, stroke + 1};
  object.texts = {stroke, stroke + 1};
  return object;
}

// A view with a length of 30 from (50, 50), whose text is at (65, 61), and nothing in its way.
sheet::Sheet sheet_of() {
  sheet::Sheet sheet{210, 148, "", {}};
  sheet.layers = {layer_of("front", "visible"), layer_of("front", "centre"), layer_of("front", "dimension")};
  sheet.layers[0].strokes = {line({{50, 50}, {80, 50}, {80, 20}, {50, 20}})};
  sheet.layers[2].strokes = {line({{50, 60}, {80, 60}})};
  sheet.layers[2].texts = {{"30", {65, 61}, 3.5, 0, sheet::Align::middle, "dimension"}};
  sheet.layers[2].dimensions = {length({50, 50}, {80, 50}, "30", 0)};
  sheet.views = {{"front", "front", "1:1", {50, 20}, {80, 50}}};
  return sheet;
}

std::string found(const sheet::Sheet& sheet) {
  std::string all;
  for (const report::Finding& one : pipeline::illegible_texts(sheet)) {
    EXPECT_EQ(one.view, "front");
    EXPECT_TRUE(one.is_fault());
    all += one.what + ";";
  }
  return all;
}

// A second length beside the first one.
void add_length(sheet::Sheet& sheet, const Vec2& from, const Vec2& to, double angle, const Vec2& text) {
  sheet::Layer& layer = sheet.layers[2];
  sheet::DimensionObject object = length(from, to, "7", 1);
  object.angle = angle;
  object.points[2] = to;
  layer.strokes.push_back(line({from, to}));
  layer.texts.push_back({"7", text, 3.5, 0, sheet::Align::middle, "dimension"});
  layer.dimensions.push_back(object);
}

}  // namespace

TEST(Legibility, OfAClearSheetHasNoFault) {
  EXPECT_EQ(found(sheet_of()), "");
  sheet::Sheet sheet = sheet_of();
  add_length(sheet, {50, 70}, {80, 70}, 0, {65, 71});
  EXPECT_EQ(found(sheet), "");
}

TEST(Legibility, FindsLinesThroughTexts) {
  sheet::Sheet outline = sheet_of(), axis = sheet_of(), hatch = sheet_of();
  outline.layers[0].strokes.push_back(line({{65, 40}, {65, 90}}));
  EXPECT_EQ(found(outline), "'30' and a visible line;");
  axis.layers[1].strokes.push_back(line({{40, 62}, {90, 63}}));
  axis.layers[1].strokes.back().dashes = {6, 0.75, 0.125, 1};
  EXPECT_EQ(found(axis), "'30' and a centre line;");
  hatch.layers.push_back(layer_of("front", "hatch"));
  hatch.layers.back().fills = {{{{{60, 55}, {70, 55}, {65, 70}}}}};
  EXPECT_EQ(found(hatch), "'30' and a hatch line;");
}

TEST(Legibility, FindsDimensionsOnEachOther) {
  sheet::Sheet through = sheet_of(), on = sheet_of(), along = sheet_of(), across = sheet_of();
  add_length(through, {50, 63}, {80, 63}, 0, {65, 75});
  EXPECT_EQ(found(through), "'30' and a line of '7';");
  add_length(on, {50, 80}, {80, 80}, 0, {66, 62});
  EXPECT_EQ(found(on), "'30' and '7';");
  add_length(along, {70, 60}, {90, 60}, 0, {85, 61});
  EXPECT_EQ(found(along), "'30' and '7';");
  add_length(across, {75, 55}, {75, 85}, 90, {80, 70});
  EXPECT_EQ(found(across), "'30' and '7';");
}

TEST(Legibility, FindsLeadersOnTextsAndLeaders) {
  sheet::Sheet through = sheet_of(), across = sheet_of();
  through.layers[2].strokes.push_back(line({{60, 50}, {68, 68}, {78, 68}}));
  EXPECT_EQ(found(through), "'30' and a dimension line;");
  for (const double turn : {-1.0, 1.0}) {
    across.layers[2].strokes.push_back(line({{65 - 10 * turn, 80}, {65 + 10 * turn, 95}, {65 + 20 * turn, 95}}));
    across.layers[2].texts.push_back(
        {turn < 0 ? "R5" : "R6", {65 + 15 * turn, 96}, 3.5, 0, sheet::Align::middle, "dimension"});
  }
  EXPECT_EQ(found(across), "'R5' and 'R6';");
}

TEST(Legibility, FindsTextsInOtherViews) {
  sheet::Sheet sheet = sheet_of();
  sheet.views.push_back({"top", "top", "1:1", {60, 58}, {90, 90}});
  EXPECT_EQ(found(sheet), "'30' and the view 'top';");
}

}  // namespace epura::test::legibility_test
