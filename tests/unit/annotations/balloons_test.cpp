// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: balloons on the drawing or on each other, and leaders that cross.
#include "annotations/balloons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace epura::test::balloons_test {
namespace {

double side(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool cross(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return side(a[0], a[1], b[0]) * side(a[0], a[1], b[1]) < 0 && side(b[0], b[1], a[0]) * side(b[0], b[1], a[1]) < 0;
}

void add_outline(drawing::ViewDrawing& drawing, const sheet::Rectangle& box) {
  const std::vector<Vec2> corners{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  for (std::size_t i = 0; i < 4; ++i) {
    drawing.segments.push_back({});
    drawing.segments.back().from = corners[i];
    drawing.segments.back().to = corners[(i + 1) % 4];
    drawing.segments.back().visible = true;
  }
}

// Items in the middle of a view, with a dimension on one side.
TEST(Balloons, AreOutsideTheViewAndTheirLeadersDoNotCross) {
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  const sheet::Rectangle view{{60, 60}, {160, 120}};
  drawing::ViewDrawing drawing;
  drawing.box = {view.min, view.max};
  add_outline(drawing, view);
  std::vector<sheet::BalloonTarget> targets;
  for (int i = 0; i < 12; ++i) targets.push_back({std::to_string(i + 1), {92.0 + 12 * (i % 4), 78.0 + 12 * (i / 4)}});
  const sheet::Rectangle dimension{{60, 124}, {160, 135}};
  const sheet::Neighbours around{sheet::Rectangle{{20, 10}, {287, 200}}, {sheet::turned_box(dimension)}};
  sheet::Layer layer;
  EXPECT_TRUE(sheet::place_balloons(layer, targets, drawing, style, around).empty());
  ASSERT_EQ(layer.texts.size(), 12U);
  std::vector<std::vector<Vec2>> leaders;
  std::vector<Vec2> centres;
  for (const sheet::Stroke& stroke : layer.strokes)
    stroke.curves.empty() ? leaders.push_back(stroke.points) : centres.push_back(stroke.curves.front().centre);
  ASSERT_EQ(leaders.size(), 12U);
  const double radius = sheet::balloon_radius(style.text);
  for (std::size_t i = 0; i < leaders.size(); ++i) {
    const sheet::Rectangle circle{centres[i] - radius, centres[i] + radius};
    EXPECT_FALSE(circle.overlaps(view)) << targets[i].number;
    EXPECT_FALSE(circle.overlaps(dimension)) << targets[i].number;
    EXPECT_TRUE(around.paper->holds(circle));
    EXPECT_EQ(leaders[i][1], targets[i].point);
    EXPECT_NEAR(glm::length(leaders[i][0] - centres[i]), radius, 1e-9);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(cross(leaders[i], leaders[j])) << targets[i].number << " and " << targets[j].number;
      EXPECT_GT(glm::length(centres[i] - centres[j]), 2 * radius);
    }
  }
}

// Rows of parts: leaders go over no others, since there is room between the rows.
TEST(Balloons, StandBetweenPartsInsteadOfPointingOverThem) {
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  drawing::ViewDrawing drawing;
  drawing.box = {{100, 100}, {260, 220}};
  std::vector<sheet::BalloonTarget> targets;
  std::vector<sheet::Rectangle> parts;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 5; ++column) {
      const Vec2 min(100 + 34 * column, 100 + 34 * row), max = min + Vec2(24, 18);
      parts.push_back({min, max});
      targets.push_back({std::to_string(parts.size()), parts.back().centre()});
      add_outline(drawing, parts.back());
    }
  sheet::Layer layer;
  EXPECT_TRUE(sheet::place_balloons(layer, targets, drawing, style, {sheet::Rectangle{{20, 20}, {400, 300}}}).empty());
  int leaders = 0;
  for (const sheet::Stroke& stroke : layer.strokes) {
    if (!stroke.curves.empty()) continue;
    ++leaders;
    const auto over = std::ranges::count_if(parts, [&](const sheet::Rectangle& part) {
      return sheet::overlap(sheet::line_box(stroke.points[0], stroke.points[1]), sheet::turned_box(part));
    });
    EXPECT_EQ(over, 1) << "its own part";
  }
  EXPECT_EQ(leaders, 20);
}

// Of texts in a row, the second upright: each touches nothing, and needs a leader only where the others leave no room.
TEST(Balloons, BesideTextsTouchNothing) {
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  std::vector<sheet::TurnedBox> texts{
      {{50, 50}, {1, 0}, {8, 2}}, {{75, 50}, {0, 1}, {8, 2}}, {{50, 56}, {1, 0}, {8, 2}}};
  std::vector<sheet::BalloonTarget> targets;
  for (const sheet::TurnedBox& box : texts)
    targets.push_back({std::to_string(targets.size() + 1), box.centre, false, box});
  targets.push_back({"104", texts[0].centre, false, texts[0]});
  drawing::ViewDrawing drawing;
  drawing.box = {{0, 0}, {40, 100}};
  drawing.segments.push_back({});
  drawing.segments.back().from = {40, 0};
  drawing.segments.back().to = {40, 100};
  const sheet::Neighbours around{sheet::Rectangle{{0, 0}, {100, 100}}, texts};
  sheet::Layer layer;
  EXPECT_TRUE(sheet::place_balloons(layer, targets, drawing, style, around).empty());
  ASSERT_EQ(layer.texts.size(), 4U);
  EXPECT_EQ(layer.strokes.size(), 4U) << "leaders";
  std::vector<sheet::TurnedBox> circles;
  for (const sheet::Stroke& stroke : layer.strokes) {
    if (stroke.curves.empty()) continue;
    const auto& circle = stroke.curves.front();
    circles.push_back({circle.centre, {1, 0}, Vec2(glm::length(stroke.points.front() - circle.centre))});
    EXPECT_EQ(sheet::ink_in(circles.back(), drawing), 0);
    for (const sheet::TurnedBox& text : texts) EXPECT_FALSE(sheet::overlap(circles.back(), text));
    for (std::size_t i = 0; i + 1 < circles.size(); ++i)
      EXPECT_GT(glm::length(circles[i].centre - circles.back().centre), 2 * circles[i].half.x);
  }
  EXPECT_EQ(circles.size(), 4U);
}

TEST(Balloons, AreLeftOutWhereThereIsNoPlace) {
  const sheet::Lettering lettering;
  const std::vector<sheet::BalloonTarget> targets{{"7", {50, 50}}};
  sheet::Layer layer;
  const sheet::Rectangle paper{{0, 0}, {100, 100}};
  drawing::ViewDrawing drawing;
  drawing.box = {paper.min, paper.max};
  add_outline(drawing, paper);
  const auto left_out = sheet::place_balloons(layer, targets, drawing, {lettering, 0.25}, {paper});
  EXPECT_EQ(left_out, std::vector<std::string>{"7"});
  EXPECT_TRUE(layer.strokes.empty());
}

}  // namespace
}  // namespace epura::test::balloons_test
