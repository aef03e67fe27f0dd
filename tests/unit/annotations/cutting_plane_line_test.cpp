// SPDX-License-Identifier: Apache-2.0
#include "annotations/cutting_plane_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shapes.hpp"

namespace epura::test::cutting_plane_line_test {
namespace {

constexpr sheet::LineWidths widths{0.5, 0.25};

cut::CuttingSurface plane_at(const Vec3& point, const Vec3& normal) {
  return cut::plane_surface(scene::make_cutting_plane({{"B", "--section"}, point, normal}));
}

cut::CuttingSurface stepped(const std::vector<Vec3>& path) {
  return cut::make_cutting_surface({{"B", "a.toml"}, Vec3(0), Vec3(0, -1, 0), {path, "a.toml"}});
}

// Page coordinates are x and y of the world.
drawing::ViewDrawing from_top() {
  Result top = draw(world_of(box({10, 20, 0}, {50, 40, 5})), from_above());
  return drawing::make_drawing({top.world, top.view, top.drawn, top.hidden}, view::make_paper_map(top.view, 1, Vec2(0)),
                               {"top", true});
}

TEST(CuttingPlaneLine, CrossesTheInkAndEndsPastIt) {
  const drawing::ViewDrawing parent = from_top();
  const cut::CuttingSurface plane = plane_at({0, 30, 0}, {0, -1, 0});
  const auto layer = sheet::cutting_plane_line(parent, plane, widths);
  ASSERT_TRUE(layer);
  EXPECT_EQ(layer->name, parent.name + "/cutting-plane");
  const double y = (parent.box.min.y + parent.box.max.y) / 2;
  const sheet::Stroke& chain = layer->strokes.at(0);
  EXPECT_GT(chain.dashes.dots, 0);
  for (const Vec2& p : chain.points) EXPECT_NEAR(p.y, y, 1e-12);
  const auto [left, right] = std::minmax(chain.points[0].x, chain.points[1].x);
  EXPECT_LT(left, parent.box.min.x - 3);
  EXPECT_GT(right, parent.box.max.x + 3);

  ASSERT_EQ(layer->texts.size(), 2U);
  for (const sheet::Text& text : layer->texts) {
    EXPECT_EQ(text.text, "B");
    EXPECT_EQ(text.angle, 0);
    EXPECT_LT(text.at.y, y);  // on the side of the viewer
    EXPECT_TRUE(text.at.x < left || text.at.x > right);
    const double past = std::max(parent.box.min.x - text.at.x, text.at.x - parent.box.max.x) + text.height / 2;
    EXPECT_NEAR(past, sheet::cutting_plane_room(parent.projection, plane, widths).x, 1e-12);
  }
  // Two wide ends and two arrow heads, whose tips come to the wide ends from below.
  ASSERT_EQ(layer->fills.size(), 4U);
  int heads = 0;
  for (const sheet::Fill& fill : layer->fills) {
    if (fill.rings[0].size() != 3) continue;
    ++heads;
    EXPECT_NEAR(fill.rings[0][0].y, y - widths.wide / 2, 1e-12);
    EXPECT_LT(fill.rings[0][1].y, fill.rings[0][0].y);
  }
  EXPECT_EQ(heads, 2);
}

TEST(CuttingPlaneLine, PointsWhereTheSectionIsSeen) {
  const auto layer = sheet::cutting_plane_line(from_top(), plane_at({30, 0, 7}, {3, 0, 0}), widths);
  ASSERT_TRUE(layer);
  for (const sheet::Fill& fill : layer->fills)
    if (fill.rings[0].size() == 3) {
      EXPECT_GT(fill.rings[0][1].x, fill.rings[0][0].x);
    }
}

TEST(CuttingPlaneLine, OfAnOffsetSectionHasWideTurns) {
  const drawing::ViewDrawing parent = from_top();
  const auto layer =
      sheet::cutting_plane_line(parent, stepped({{0, 25, 0}, {30, 25, 0}, {30, 35, 0}, {60, 35, 0}}), widths);
  ASSERT_TRUE(layer);
  // A chain for each leg, and two arrows.
  ASSERT_EQ(layer->strokes.size(), 5U);
  const Vec2 middle = (parent.box.min + parent.box.max) / 2.0;
  for (const Vec2& p : layer->strokes[1].points) EXPECT_NEAR(p.x, middle.x, 1e-12);
  // Two ends with heads, two turns of two legs.
  EXPECT_EQ(layer->fills.size(), 8U);
  ASSERT_EQ(layer->texts.size(), 2U);
  EXPECT_NEAR(layer->texts[1].at.y - layer->texts[0].at.y, 10, 1e-12);
}

TEST(CuttingPlaneLine, OfAHalfSectionHasOneArrow) {
  const drawing::ViewDrawing parent = from_top();
  const cut::CuttingSurface half = stepped({{0, 30, 0}, {30, 30, 0}, {30, 0, 0}});
  const auto layer = sheet::cutting_plane_line(parent, half, widths);
  ASSERT_TRUE(layer);
  EXPECT_EQ(layer->strokes.size(), 3U);
  EXPECT_EQ(layer->fills.size(), 5U);
  ASSERT_EQ(layer->texts.size(), 2U);
  const sheet::Text& below = layer->texts[1];
  EXPECT_NEAR(below.at.x, (parent.box.min.x + parent.box.max.x) / 2, 1e-12);
  EXPECT_LE(parent.box.min.y - below.at.y, sheet::cutting_plane_room(parent.projection, half, widths).y);
}

// Its ends are past the ink on their lines, with arrows perpendicular to these.
TEST(CuttingPlaneLine, OfAnAlignedSectionHasArrowsAcrossItsPlanes) {
  const drawing::ViewDrawing parent = from_top();
  scene::SectionDescription section{{"B", "a.toml"}, Vec3(0), Vec3(0, -1, 0)};
  section.path = {std::vector<Vec3>{{0, 30, 0}, {30, 30, 0}, {40, 40, 0}}, "a.toml"};
  section.aligned = {true, "a.toml"};
  const cut::CuttingSurface surface = cut::make_cutting_surface(section);
  const auto layer = sheet::cutting_plane_line(parent, surface, widths);
  ASSERT_TRUE(layer);
  // A chain for each leg, and two arrows; two ends with heads, a turn of two legs.
  ASSERT_EQ(layer->strokes.size(), 4U);
  EXPECT_EQ(layer->fills.size(), 6U);
  const auto direction = [&](std::size_t stroke) {
    return glm::normalize(layer->strokes[stroke].points[1] - layer->strokes[stroke].points[0]);
  };
  const Vec2 diagonal = glm::normalize(Vec2(1, 1));
  EXPECT_LT(glm::distance(direction(1), diagonal), 1e-12);
  EXPECT_LT(glm::distance(direction(2), Vec2(0, 1)), 1e-12);
  EXPECT_LT(glm::distance(direction(3), Vec2(-diagonal.x, diagonal.y)), 1e-12);
  const auto past = [&](std::size_t stroke, const Vec2& end, const Vec2& outwards) {
    return glm::dot(layer->strokes[stroke].points[1] - end, outwards);
  };
  const Vec2 middle = (parent.box.min + parent.box.max) / 2.0;
  EXPECT_NEAR(past(3, middle + Vec2(10, 10), diagonal), past(2, middle - Vec2(20, 0), Vec2(-1, 0)), 1e-9);
  ASSERT_EQ(layer->texts.size(), 2U);
  const Vec2 room = sheet::cutting_plane_room(parent.projection, surface, widths);
  EXPECT_LT(layer->texts[1].at.y + layer->texts[1].height - parent.box.max.y, room.y);
}

TEST(CuttingPlaneLine, IsNotWhereStepsAreSeenFromTheFront) {
  const cut::CuttingSurface steps = stepped({{0, 25, 0}, {30, 25, 0}, {30, 35, 0}, {60, 35, 0}});
  EXPECT_TRUE(sheet::sees_edge_on(from_above(), steps));
  EXPECT_FALSE(sheet::sees_edge_on(orthographic({1, 0, 0}, {0, 0, 1}), steps));
}

TEST(CuttingPlaneLine, ReplacesCentreLines) {
  const drawing::ViewDrawing parent = from_top();
  const auto marks = sheet::cutting_plane_line(parent, plane_at({0, 30, 0}, {0, -1, 0}), widths);
  ASSERT_TRUE(marks);
  const Vec2 middle = (parent.box.min + parent.box.max) / 2.0;
  sheet::Layer centre = sheet::empty_layer("top", scene::SheetLine::centre, widths);
  const auto add = [&](const Vec2& from, const Vec2& to) { centre.strokes.push_back({{middle + from, middle + to}}); };
  add({-5, 0}, {5, 0});
  add({0, -5}, {0, 5});
  add({-5, 1}, {5, 1});
  add({0, 0}, {60, 0});
  const std::vector<sheet::Stroke> before = centre.strokes;
  sheet::give_way(centre, *marks, widths);
  ASSERT_EQ(centre.strokes.size(), 3U);
  EXPECT_EQ(centre.strokes[0].points, before[1].points);
  EXPECT_EQ(centre.strokes[1].points, before[2].points);
  // The end of the wide line: 0.8 + 1.4 letter heights past the ink.
  EXPECT_NEAR(centre.strokes[2].points[0].x, parent.box.max.x + 2.2 * 5, 1e-9);
  EXPECT_EQ(centre.strokes[2].points[1], before[3].points[1]);
}

TEST(DividingLine, ReplacesCentreLinesOfAHalfSection) {
  drawing::ViewDrawing front =
      draw(world_of(box({0, 0, 0}, {40, 20, 10})), orthographic({0, -1, 0}, {0, 0, 1})).drawing;
  const cut::CuttingSurface half = stepped({{0, 10, 0}, {20, 10, 0}, {20, 0, 0}});
  sheet::Layer centre = sheet::empty_layer("front", scene::SheetLine::centre, widths);
  const double x = (front.box.min.x + front.box.max.x) / 2;
  centre.strokes.push_back({{{x, front.box.min.y}, {x, front.box.max.y}}});
  centre.strokes.push_back({{{x, front.box.min.y}, {x + 1, front.box.max.y}}});
  sheet::add_dividing_lines(centre, front, half, widths);
  ASSERT_EQ(centre.strokes.size(), 2U);
  const std::vector<Vec2>& line = centre.strokes[1].points;
  EXPECT_NEAR(line[0].x, x, 1e-9);
  EXPECT_NEAR(line[1].x, x, 1e-9);
  EXPECT_NEAR(std::abs(line[0].y - line[1].y), front.box.max.y - front.box.min.y + 6, 1e-9);
}

TEST(CuttingPlaneLine, IsOnlyWhereThePlaneIsALine) {
  EXPECT_FALSE(sheet::cutting_plane_line(from_top(), plane_at({0, 30, 0}, {0, -1, 0.01}), widths));
  EXPECT_FALSE(sheet::cutting_plane_line(from_top(), plane_at({0, 30, 2}, {0, 0, 1}), widths));
  const drawing::ViewDrawing central =
      draw(world_of(box({0, 0, 0}, {1, 1, 1})), perspective({0.5, -5, 0.5}, {0, 0, 0}, {0, -1, 0}, {0, 0, 1})).drawing;
  EXPECT_FALSE(sheet::cutting_plane_line(central, plane_at({0.5, 0, 0}, {1, 0, 0}), widths));
}

// Planes 20 mm apart that look apart: the tails of their arrows would meet, and one letter be over the other.
TEST(CuttingPlaneLine, LettersOfNeighboursAreApart) {
  const drawing::ViewDrawing parent = from_top();
  const auto named = [](const char* name, double x, double side) {
    return cut::plane_surface(scene::make_cutting_plane({{name, "--section"}, Vec3(x, 0, 0), Vec3(side, 0, 0)}));
  };
  for (const double apart : {2.0, 12.0, 20.0, 24.0}) {
    const std::vector<cut::CuttingSurface> planes{named("B", 20, 1), named("C", 20 + apart, -1)};
    const auto lines = sheet::cutting_plane_lines(parent, planes, widths);
    ASSERT_TRUE(lines[0] && lines[1]);
    EXPECT_EQ(lines[0]->texts[0].at, sheet::cutting_plane_line(parent, planes[0], widths)->texts[0].at);
    for (const sheet::Text& b : lines[0]->texts)
      for (const sheet::Text& c : lines[1]->texts)
        EXPECT_TRUE(std::abs(b.at.x - c.at.x) >= b.height || std::abs(b.at.y - c.at.y) >= b.height) << apart;
  }
}

}  // namespace
}  // namespace epura::test::cutting_plane_line_test
