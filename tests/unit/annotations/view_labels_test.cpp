// SPDX-License-Identifier: Apache-2.0
#include "annotations/view_labels.hpp"

#include <gtest/gtest.h>

namespace epura::test::view_labels_test {
namespace {

const sheet::Rectangle area{{0, 0}, {200, 150}};

// A label at (100, 50), 5 mm high, of the view "front", and lines in a layer.
sheet::Sheet sheet_with(const std::string& layer, std::vector<sheet::Stroke> strokes) {
  sheet::Sheet sheet{200, 150, "", {{"sheet/text", {"text", 0.35}, {}}, {layer, {"line", 0.25}, std::move(strokes)}}};
  sheet.views.push_back({"front", "front", "1:1", {70, 20}, {130, 47}});
  sheet.layers[0].texts.push_back({"A-A", {100, 50}, 5, 0, sheet::Align::middle, "label"});
  return sheet;
}

Vec2 position_among(const std::string& layer, std::vector<sheet::Stroke> strokes) {
  sheet::Sheet sheet = sheet_with(layer, std::move(strokes));
  sheet::clear_labels(sheet, area, sheet::Lettering());
  return sheet.layers[0].texts[0].at;
}

TEST(ViewLabels, FreeLabelsStay) {
  EXPECT_EQ(position_among("front/visible", {}), Vec2(100, 50));
  EXPECT_EQ(position_among("front/visible", {{{{80, 47}, {120, 47}}}}), Vec2(100, 50)) << "the view below it";
}

TEST(ViewLabels, RiseAboveTheEndOfACentreLine) {
  const Vec2 at = position_among("front/centre-lines", {{{{100, 20}, {100, 53}}}});
  EXPECT_EQ(at.x, 100);
  EXPECT_GE(at.y, 54);
  EXPECT_LE(at.y, 56);
}

TEST(ViewLabels, GoAsideOfAHighLine) {
  const Vec2 at = position_among("front/centre-lines", {{{{100, 20}, {100, 149}}}});
  EXPECT_GE(std::abs(at.x - 100), sheet::Lettering().width("A-A", 5) / 2 + 1);
  EXPECT_EQ(at.y, 50);
}

TEST(ViewLabels, AreNotBetweenAViewAndItsDimension) {
  EXPECT_GE(position_among("front/dimensions", {{{{60, 60}, {140, 60}}}}).y, 61);
  EXPECT_EQ(position_among("front/dimensions", {{{{110, 60}, {140, 60}}}}), Vec2(100, 50)) << "beside it";
  EXPECT_EQ(position_among("top/dimensions", {{{{60, 60}, {140, 60}}}}), Vec2(100, 50)) << "of the view above";
}

TEST(ViewLabels, StayIfNothingIsFree) {
  std::vector<sheet::Stroke> strokes;
  for (double x = 0.5; x < 200; x += 2) strokes.push_back({{{x, 0}, {x, 150}}});
  EXPECT_EQ(position_among("front/visible", strokes), Vec2(100, 50));
}

}  // namespace
}  // namespace epura::test::view_labels_test
