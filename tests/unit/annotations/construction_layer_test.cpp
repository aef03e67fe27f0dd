// SPDX-License-Identifier: Apache-2.0
#include "annotations/construction_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace epura::sheet::construction_layer_test {
namespace {

using construction::Extent;
using construction::Figure;

const Rectangle area{{0, 0}, {100, 80}};

Layer drawn(const Figure& figure, const ConstructionRoom& room = {area}) {
  const Lettering lettering;
  return construction_layer("view", figure, room, {lettering, 0.25}).layer;
}

void expect_line(const std::optional<std::array<Vec2, 2>>& line, const Vec2& from, const Vec2& to) {
  ASSERT_TRUE(line);
  EXPECT_NEAR(glm::length((*line)[0] - from), 0, 1e-9);
  EXPECT_NEAR(glm::length((*line)[1] - to), 0, 1e-9);
}

TEST(ConstructionLayer, LinesEndAtTheBorder) {
  expect_line(clipped({{10, 10}, {30, 40}}, area), {10, 10}, {30, 40});
  expect_line(clipped({{10, 10}, {200, 10}}, area), {10, 10}, {100, 10});
  expect_line(clipped({{50, 40}, {51, 41}, Extent::ray}, area), {50, 40}, {90, 80});
  expect_line(clipped({{50, 40}, {51, 41}, Extent::line}, area), {10, 0}, {90, 80});
  EXPECT_FALSE(clipped({{-5, 0}, {-5, 9}, Extent::line}, area));
  EXPECT_FALSE(clipped({{10, 10}, {10, 10}}, area));
  // A vanishing point a light-minute away: the line keeps its direction.
  expect_line(clipped({{10, 10}, {1.8e13, 10 + 0.9e13}}, area), {10, 10}, {100, 55});
}

TEST(ConstructionLayer, DistancesAreReadable) {
  EXPECT_EQ(distance_text(512.4), "512 mm");
  EXPECT_EQ(distance_text(1250), "1.25 m");
  EXPECT_EQ(distance_text(3e9), "3000 km");
}

// Beyond the room, an arrow on the border points along the guide, with the distance from there.
TEST(ConstructionLayer, ArrowsPointToWhatIsBeyond) {
  Figure figure;
  figure.points.push_back({{"VP", "x"}, {1e12, 40}, {50, 40}});
  const Layer layer = drawn(figure);
  ASSERT_EQ(layer.fills.size(), 1U);
  EXPECT_NEAR(layer.fills[0].rings[0][0].x, 100, 1e-9) << "the tip";
  EXPECT_NEAR(layer.fills[0].rings[0][0].y, 40, 1e-9);
  ASSERT_EQ(layer.texts.size(), 3U);
  EXPECT_EQ(layer.texts[0].text, "VP");
  EXPECT_EQ(layer.texts[1].text, "x");
  EXPECT_EQ(layer.texts[2].text, " 1000000 km");
  for (const Stroke& stroke : layer.strokes)
    for (const Vec2& p : stroke.points) EXPECT_TRUE(area.holds({p, p}, 1e-9));
}

// Symbols of points on many lines touch none of these, and not each other.
TEST(ConstructionLayer, SymbolsAreClearOfLines) {
  Figure figure;
  for (int i = 0; i < 5; ++i) {
    figure.points.push_back({{"A", std::to_string(i)}, {20.0 + 12 * i, 40}});
    figure.lines.push_back({{20.0 + 12 * i, 5}, {20.0 + 12 * i, 75}});
  }
  figure.lines.push_back({{0, 40}, {1, 40}, Extent::line, {"HL"}});
  const Layer layer = drawn(figure);
  const Lettering lettering;
  ASSERT_EQ(layer.texts.size(), 11U);
  for (const Text& text : layer.texts) {
    const TurnedBox box = box_of(text, lettering);
    for (const Stroke& stroke : layer.strokes)
      for (std::size_t i = 1; i < stroke.points.size(); ++i)
        EXPECT_FALSE(overlap(box, line_box(stroke.points[i - 1], stroke.points[i]))) << text.text;
    for (const Text& other : layer.texts) {
      if (&other == &text) continue;
      EXPECT_FALSE(overlap(box, box_of(other, lettering))) << text.text << " " << other.text;
    }
  }
}

// A circle that the border cuts is drawn inside it only; one within stays one curve.
TEST(ConstructionLayer, CirclesEndAtTheBorder) {
  Figure figure;
  figure.curves.push_back({{50, 40}, {60, 0}, {0, 60}});
  figure.curves.push_back({{50, 40}, {10, 0}, {0, 10}});
  const Layer layer = drawn(figure);
  ASSERT_FALSE(layer.strokes.empty());
  EXPECT_TRUE(layer.strokes.back().closed);
  for (const Stroke& stroke : layer.strokes) {
    EXPECT_EQ(stroke.curves.size(), 1U);
    for (const Vec2& p : stroke.points) EXPECT_TRUE(area.holds({p, p}));
  }
}

}  // namespace
}  // namespace epura::sheet::construction_layer_test
