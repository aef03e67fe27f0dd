// SPDX-License-Identifier: Apache-2.0
// Where dimensions stand: outside the outline, in order, and out of each other's way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "dimensions/obstacles.hpp"
#include "dimensions_support.hpp"
#include "errors.hpp"
#include "sheet/box_index.hpp"
#include "sizes/overall.hpp"

namespace epura::test::dimension_places_test {
namespace {

sheet::TurnedBox box_of(const sheet::Text& text) {
  const double angle = text.angle * std::numbers::pi / 180;
  const Vec2 along(std::cos(angle), std::sin(angle)), up(-along.y, along.x);
  EXPECT_EQ(text.align, sheet::Align::middle);
  static const sheet::Lettering lettering;
  return {text.at + up * (text.height / 2), along, {lettering.width(text.text, text.height) / 2, text.height / 2}};
}

void expect_texts_apart(const sheet::Layer& layer) {
  for (std::size_t i = 0; i < layer.texts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(sheet::overlap(box_of(layer.texts[i]), box_of(layer.texts[j])))
          << layer.texts[i].text << " over " << layer.texts[j].text;
}

void expect_no_line_through_a_text(const sheet::Layer& layer, const drawing::ViewDrawing& drawing) {
  for (const sheet::Text& text : layer.texts) {
    EXPECT_EQ(sheet::ink_in(box_of(text), drawing), 0) << text.text;
    for (const sheet::Stroke& stroke : layer.strokes)
      for (std::size_t i = 1; i < stroke.points.size(); ++i)
        EXPECT_FALSE(sheet::overlap(box_of(text), sheet::line_box(stroke.points[i - 1], stroke.points[i])))
            << text.text;
  }
}

// A flight of steps in the plane of the front view; vertex 2 i is the outer corner of step i.
Shape stairs(int steps) {
  Shape shape;
  for (int i = 0; i < steps; ++i) shape.add(box({0, 0, 10.0 * i}, {12.0 * (steps - i), 20, 10.0 * (i + 1)}));
  return shape;
}

TEST(DimensionPlaces, LookLikeDimensions) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const sheet::Layer layer =
      layer_of(world, front, {dimension("overall", {}, "width"), dimension("overall", {}, "height")});
  EXPECT_EQ(layer.name, "view/dimensions");
  EXPECT_EQ(layer.style.width, 0.25);
  ASSERT_EQ(layer.strokes.size(), 6u);  // two extension lines and the dimension line of each
  // The outline is 60 by 40 around (100, 100). Gap and overshoot are 8 line widths.
  EXPECT_EQ(layer.strokes[0].points, (std::vector<Vec2>{{70, 78}, {70, 68}}));
  EXPECT_EQ(layer.strokes[1].points, (std::vector<Vec2>{{130, 78}, {130, 68}}));
  EXPECT_EQ(layer.strokes[2].points, (std::vector<Vec2>{{70, 70}, {130, 70}}));
  EXPECT_EQ(layer.texts[0].at, Vec2(100, 70 + 0.3 * 3.5));
  EXPECT_EQ(layer.texts[0].angle, 0);
  EXPECT_EQ(layer.texts[0].role, "dimension");
  // Read from the right.
  EXPECT_EQ(layer.strokes[5].points, (std::vector<Vec2>{{140, 80}, {140, 120}}));
  EXPECT_EQ(layer.texts[1].at, Vec2(140 - 0.3 * 3.5, 100));
  EXPECT_EQ(layer.texts[1].angle, 90);
  // Arrows of 20 degrees that end at the extension lines.
  const std::vector<Vec2> arrow = layer.fills[0].rings[0];
  EXPECT_EQ(arrow[0], Vec2(70, 70));
  const Vec2 a = arrow[1] - arrow[0], b = arrow[2] - arrow[0];
  EXPECT_NEAR(std::acos(glm::dot(glm::normalize(a), glm::normalize(b))) * 180 / std::numbers::pi, 20, 1e-9);
}

// Each line on which strokes are, and the parts that they cover, from where to where, in order.
std::map<std::array<double, 2>, std::vector<std::array<double, 2>>> upright_parts(const sheet::Layer& layer) {
  std::map<std::array<double, 2>, std::vector<std::array<double, 2>>> parts;
  for (const sheet::Stroke& stroke : layer.strokes) {
    const Vec2 &a = stroke.points.front(), &b = stroke.points.back();
    const auto rounded = [](double x) { return std::round(1e6 * x) / 1e6; };
    for (const int axis : {0, 1})
      if (rounded(a[axis]) == rounded(b[axis]))
        parts[{static_cast<double>(axis), rounded(a[axis])}].push_back(
            {std::min(a[1 - axis], b[1 - axis]), std::max(a[1 - axis], b[1 - axis])});
  }
  for (auto& [line, of_line] : parts) std::sort(of_line.begin(), of_line.end());
  return parts;
}

TEST(DimensionPlaces, ExtensionLinesAreDrawnOnce) {
  const world::World world = placed(stairs(3));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), 2);
  std::vector<scene::DimensionDescription> dimensions{dimension("overall", {}, "width")};
  for (const int v : {9, 17}) {
    dimensions.push_back(dimension("linear", {0, v}, "horizontal"));
    dimensions.back().anchors[0] = Vec3(0, 0, 0);
  }
  const sheet::Layer layer = layer_of(world, front, dimensions);
  ASSERT_EQ(layer.texts.size(), 3U);
  std::size_t shared = 0;
  for (const auto& [line, of_line] : upright_parts(layer)) {
    for (std::size_t i = 1; i < of_line.size(); ++i) EXPECT_GE(of_line[i][0], of_line[i - 1][1] - 1e-9);
    // Those at the corner that all have in common begin and end as if the last one were alone.
    if (line[0] != 0 || std::abs(line[1] - 64) > 1e-6) continue;
    shared = of_line.size();
    double length = 0;
    for (const auto& [from, to] : of_line) length += to - from;
    EXPECT_NEAR(of_line.back()[1] - of_line.front()[0], length, 1e-9) << "without a gap";
    EXPECT_NEAR(length, 10 + 2 * sheet::dimension_step(3.5), 1e-6) << "gap and overshoot are equally long";
  }
  EXPECT_GE(shared, 1U);
}

TEST(DimensionPlaces, SmallInsideLarge) {
  const world::World world = placed(stairs(3));  // boxes 36, 24 and 12 wide
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), 2);
  std::vector<scene::DimensionDescription> dimensions{dimension("overall", {}, "width")};
  for (const int v : {9, 1, 17}) dimensions.push_back(dimension("linear", {0, v}, "horizontal"));
  for (scene::DimensionDescription& one : dimensions)
    if (*one.type == DimensionType::linear) one.anchors[0] = Vec3(0, 0, 0);
  const sheet::Layer layer = layer_of(world, front, dimensions);
  std::vector<std::pair<double, double>> lines;  // span and distance from the outline
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const auto [a, b] = tips(layer, i);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_TRUE(a.y < front.box.min.y - 9.99 || a.y > front.box.max.y + 9.99);
    lines.emplace_back(std::abs(a.x - b.x), a.y < 100 ? front.box.min.y - a.y : a.y - front.box.max.y);
  }
  EXPECT_NEAR(lines[3].first, 24, 1e-6);
  std::sort(lines.begin(), lines.end());
  for (std::size_t i = 1; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(lines[i].second - lines[j].second) > 1e-9) {
        EXPECT_GE(std::abs(lines[i].second - lines[j].second), 7.99);
      }
  expect_texts_apart(layer);
  expect_no_line_through_a_text(layer, front);
}

// Symmetrical lengths inside one another, whose texts are wider than they are: beside its extension lines, each text
// would be on those of a wider length.
TEST(DimensionPlaces, NarrowLengthsInsideOneAnother) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  std::vector<scene::DimensionDescription> dimensions;
  for (int i = 1; i <= 8; ++i) {
    scene::DimensionDescription& one = dimensions.emplace_back(dimension("linear", {}, "horizontal"));
    for (const double side : {-1.0, 1.0}) one.anchors.emplace_back(Vec3(30 + 2 * side * i, 0, 0));
    one.text = {"12× wide <>", "scene.toml:10:8"};
  }
  // There is no room above the view.
  const sheet::Neighbours neighbours{sheet::Rectangle{{0, 0}, {200, 150}}, {}, {}};
  const sheet::Lettering lettering;
  const sheet::PlacedLayer placed_layer =
      sheet::place_dimensions({world, front, dimensions, dimensions.size()}, {lettering, 0.25}, neighbours);
  EXPECT_EQ(placed_layer.texts_left_out, std::vector<std::string>());
  EXPECT_FALSE(placed_layer.has_conflicts);
  expect_texts_apart(placed_layer.layer);
  expect_no_line_through_a_text(placed_layer.layer, front);
}

TEST(DimensionPlaces, NeighboursShareALine) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  scene::DimensionDescription left = dimension("linear", {0}, "horizontal"),
                              right = dimension("linear", {1}, "horizontal");
  for (scene::DimensionDescription* one : {&left, &right}) one->anchors.emplace_back(Vec3(25, 0, 0));
  const sheet::Layer layer = layer_of(world, front, {left, right});
  EXPECT_NEAR(tips(layer, 0)[0].y, tips(layer, 1)[0].y, 1e-9);
  expect_texts_apart(layer);
}

TEST(DimensionPlaces, ArrowsAndTextsGoOutsideWhereThereIsNoRoom) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  scene::DimensionDescription narrow = dimension("linear", {0}, "horizontal"), wide = narrow;
  narrow.anchors.emplace_back(Vec3(2.25, 0, 0));
  wide.anchors.emplace_back(Vec3(30, 0, 0));
  const auto arrow_points_right = [&](const scene::DimensionDescription& one) {
    const std::vector<Vec2> ring = layer_of(world, front, {one}).fills[0].rings[0];  // at the left end
    return ring[0].x > ring[1].x;
  };
  EXPECT_TRUE(arrow_points_right(narrow));
  EXPECT_FALSE(arrow_points_right(wide));
  const sheet::Layer layer = layer_of(world, front, {narrow});
  EXPECT_EQ(layer.texts[0].text, "2.25");
  const sheet::TurnedBox text = box_of(layer.texts[0]);
  EXPECT_GT(text.centre.x - text.half.x, 72.25);
  // The line runs on under the text.
  EXPECT_GE(layer.strokes[2].points[1].x, text.centre.x + text.half.x);
}

TEST(DimensionPlaces, AnOffsetIsObeyed) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const auto page = [&](int v) { return Vec2(front.world_to_page * Vec4(world.points[std::size_t(v)], 1)); };
  const auto tip_of = [&](scene::DimensionDescription one, double offset) {
    one.offset = {offset, ""};
    return tips(layer_of(world, front, {one}))[0];
  };
  const scene::DimensionDescription width = dimension("linear", {0, 2}, "horizontal");
  const scene::DimensionDescription height = dimension("linear", {0, 2}, "vertical");
  EXPECT_NEAR(tip_of(width, 13).y, page(2).y + 13, 1e-6);
  EXPECT_NEAR(tip_of(width, -13).y, page(0).y - 13, 1e-6);
  EXPECT_NEAR(tip_of(height, 7).x, page(2).x + 7, 1e-6);
  EXPECT_NEAR(tip_of(height, -7).x, page(0).x - 7, 1e-6);
  // Upwards from the longest side is to its upper left.
  const Vec2 tip = tip_of(dimension("aligned", {2, 0}), 20);
  EXPECT_NEAR(glm::length(tip - page(0)), 20, 1e-6);
  EXPECT_GT(tip.y, page(0).y);
  EXPECT_NEAR(glm::length(tip_of(dimension("angular", {0, 1, 2}), 33) - page(0)), 33, 1e-6);
}

TEST(DimensionPlaces, LeadersOfAnOffset) {
  const world::World world = placed(cylinder(64, 20, 7));
  const drawing::ViewDrawing top = drawing_of(world, from_above());
  scene::DimensionDescription radius = dimension("radius", {0});
  for (const double offset : {12.0, -12.0}) {
    radius.offset = {offset, ""};
    const std::vector<Vec2> leader = layer_of(world, top, {radius}).strokes[0].points;
    EXPECT_NEAR(glm::length(leader[0] - Vec2(100, 100)), 20, 1e-6);
    EXPECT_NEAR(glm::length(leader[1] - Vec2(100, 100)), 20 + offset, 1e-6);
  }
}

TEST(DimensionPlaces, ManyAtOnce) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), 2);
  const std::vector<scene::DimensionDescription> dimensions{
      dimension("linear", {0, 1}, "horizontal"), dimension("overall", {}, "width"),
      dimension("overall", {}, "height"),        dimension("aligned", {0, 2}),
      dimension("linear", {1, 2}, "vertical"),   dimension("angular", {0, 1, 2}),
      dimension("angular", {2, 0, 1}),           dimension("angular", {1, 2, 0})};
  const sheet::Layer layer = layer_of(world, front, dimensions);
  ASSERT_EQ(layer.texts.size(), dimensions.size());
  EXPECT_EQ(layer.fills.size(), 2 * dimensions.size());
  expect_texts_apart(layer);
  expect_no_line_through_a_text(layer, front);
}

TEST(DimensionPlaces, ManyCircles) {
  Shape plates = cylinder(64, 50, 5);
  for (int i = 0; i < 6; ++i) {
    const double a = i * std::numbers::pi / 3;
    plates.add(cylinder(48, 6, 5).moved(35 * std::cos(a), 35 * std::sin(a), 10));
  }
  const world::World world = placed(plates);
  const drawing::ViewDrawing top = drawing_of(world, from_above());
  std::vector<scene::DimensionDescription> dimensions{dimension("diameter", {0})};
  for (int i = 0; i < 6; ++i) dimensions.push_back(dimension("diameter", {128 + 96 * i}));
  const sheet::Layer layer = layer_of(world, top, dimensions);
  EXPECT_EQ(layer.texts[0].text, "⌀100");
  EXPECT_EQ(layer.texts[6].text, "⌀12");
  expect_texts_apart(layer);
  expect_no_line_through_a_text(layer, top);
}

// Of the first model vertex' circle around the z axis.
Vec2 circle_centre(const drawing::ViewDrawing& drawing) {
  const Vec4 centre = drawing.world_to_page * Vec4(0, 0, 0, 1);
  return Vec2(centre) / centre.w;
}

bool reaches_into(const sheet::Layer& layer, const sheet::Rectangle& box) {
  static const sheet::Lettering lettering;
  const std::vector<sheet::TurnedBox> boxes = sheet::boxes_of(layer, lettering);
  return sheet::BoxIndex(boxes).overlaps(sheet::turned_box(box)) > 0;
}

TEST(DimensionPlaces, AwayFromNeighboursAndOnThePaper) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));  // (70, 80) to (130, 120)
  const std::vector<scene::DimensionDescription> width{dimension("overall", {}, "width")};
  const auto layer = [&](const sheet::Neighbours& neighbours) {
    return sheet::place_dimensions({world, front, width}, {sheet::Lettering(), 0.25}, neighbours).layer;
  };
  const sheet::Rectangle below{{60, 62}, {140, 75}}, above{{60, 125}, {140, 200}}, far_below{{60, 0}, {140, 20}};
  EXPECT_TRUE(reaches_into(layer({}), below));
  const sheet::Layer on_top = layer({{}, {sheet::turned_box(below)}});
  EXPECT_FALSE(reaches_into(on_top, below));
  // What is far enough away does not matter; what bars the other side leads past the first.
  EXPECT_TRUE(reaches_into(layer({{}, {sheet::turned_box(far_below)}}), below));
  const sheet::Layer past = layer({{}, {sheet::turned_box(below), sheet::turned_box(above)}});
  EXPECT_LT(past.texts.front().at.y, below.min.y);
  const sheet::Layer inside = layer({sheet::Rectangle{{0, 75}, {200, 200}}, {}});
  EXPECT_GT(inside.texts.front().at.y, 120);
}

// Paper for one line below the view, and none beside it: what a file requires stands there, not what was only found.
TEST(DimensionPlaces, WhatIsRequiredTakesThePlaceOfWhatWasFound) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));  // (70, 80) to (130, 120)
  std::vector<scene::DimensionDescription> dimensions{dimension("overall", {}, "width"),
                                                      dimension("linear", {0, 1}, "horizontal")};
  dimensions[1].requirement = "0:0";
  dimensions[1].text = {"<> H", "scene.toml:10:8"};
  sheet::Neighbours neighbours{sheet::Rectangle{{60, 68}, {140, 121}}, {}};
  neighbours.boxes.push_back(sheet::turned_box({{71, 81}, {129, 119}}));
  const sheet::PlacedLayer both =
      sheet::place_dimensions({world, front, dimensions, 1}, {sheet::Lettering(), 0.25}, neighbours);
  ASSERT_EQ(both.layer.texts.size(), 1U);
  EXPECT_EQ(both.layer.texts[0].text, "60 H");
  EXPECT_EQ(both.left_out, std::vector<std::size_t>{0});
  dimensions[1].requirement.clear();
  const sheet::PlacedLayer found =
      sheet::place_dimensions({world, front, dimensions, 2}, {sheet::Lettering(), 0.25}, neighbours);
  EXPECT_EQ(found.left_out.size(), 1U);
}

// A letter on either side, where the line from the upper right corner would be: no other place avoids both.
TEST(DimensionPlaces, LinesAreInterruptedAtLetters) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));  // (70, 80) to (130, 120)
  const std::vector<scene::DimensionDescription> width{dimension("overall", {}, "width")};
  const sheet::Rectangle below{{126, 72}, {134, 76}}, above{{126, 124}, {134, 128}};
  const auto strokes_of = [&](const std::vector<sheet::Rectangle>& letters) {
    sheet::Neighbours neighbours;
    for (const sheet::Rectangle& letter : letters) neighbours.letters.push_back(sheet::turned_box(letter));
    return sheet::place_dimensions({world, front, width}, {sheet::Lettering(), 0.25}, neighbours).layer.strokes;
  };
  const auto has_ink_in = [](const std::vector<sheet::Stroke>& strokes, const sheet::Rectangle& letter) {
    return std::any_of(strokes.begin(), strokes.end(), [&](const sheet::Stroke& stroke) {
      return sheet::overlap(sheet::line_box(stroke.points[0], stroke.points[1]), sheet::turned_box(letter.grown(0.4)));
    });
  };
  const auto length_of = [](const std::vector<sheet::Stroke>& strokes) {
    double length = 0;
    for (const sheet::Stroke& stroke : strokes) length += glm::distance(stroke.points[0], stroke.points[1]);
    return length;
  };
  const auto free = strokes_of({}), moved = strokes_of({below}), interrupted = strokes_of({below, above});
  EXPECT_TRUE(has_ink_in(free, below));
  EXPECT_TRUE(has_ink_in(moved, above));
  for (const sheet::Rectangle& letter : {below, above}) EXPECT_FALSE(has_ink_in(interrupted, letter));
  EXPECT_EQ(interrupted.size(), free.size() + 1);
  EXPECT_NEAR(length_of(interrupted), length_of(free) - (4 + 2 * 0.5), 1e-9);
}

// Between the corners of a rhombus that are as far from its top as from its bottom.
TEST(DimensionPlaces, HorizontalOnesAreBelowIfNothingElseMatters) {
  Shape rhombus;
  rhombus.points = {{0, 0, 20}, {30, 0, 0}, {60, 0, 20}, {30, 0, 40}, {0, 9, 20}, {30, 9, 0}, {60, 9, 20}, {30, 9, 40}};
  rhombus.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  const world::World world = placed(rhombus);
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  EXPECT_LT(layer_of(world, front, {dimension("linear", {0, 2}, "horizontal")}).texts.at(0).at.y, 80);
}

// A leader avoids a line in any of its directions, although it may cost as much as the whole leader not to.
TEST(DimensionPlaces, LeadersGoWhereTheyCrossNothing) {
  constexpr double half = 0.4;  // smaller than the room between circle and text
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const double a = std::numbers::pi * (0.25 + 0.5 * quadrant), x = 6 * std::cos(a), y = 6 * std::sin(a) + 0.15;
    Shape shape = cylinder(48, 3, 5);
    shape.add(box({x - half, y - half, 0}, {x + half, y + half, 1}));
    const world::World world = placed(shape);
    const drawing::ViewDrawing top = drawing_of(world, from_above());
    const Vec2 centre = circle_centre(top);
    const sheet::Layer layer = layer_of(world, top, {dimension("diameter", {0})});
    EXPECT_FALSE(reaches_into(layer, {centre + Vec2(x, y) - Vec2(half), centre + Vec2(x, y) + Vec2(half)})) << quadrant;
  }
}

TEST(DimensionPlaces, ArcsKnowTheirCircles) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const sheet::Layer layer = layer_of(world, front, {dimension("angular", {0, 1, 2})});
  const auto arc = std::find_if(layer.strokes.begin(), layer.strokes.end(),
                                [](const sheet::Stroke& stroke) { return !stroke.curves.empty(); });
  ASSERT_NE(arc, layer.strokes.end());
  const drawing::CurvePart& part = arc->curves[0];
  EXPECT_EQ(part.last, static_cast<int>(arc->points.size()) - 1);
  for (std::size_t i = 0; i < arc->points.size(); ++i) {
    const double a = part.from + (part.to - part.from) * double(i) / part.last;
    EXPECT_LT(glm::length(arc->points[i] - (part.centre + std::cos(a) * part.u + std::sin(a) * part.v)), 1e-9);
  }
}

sheet::NamedProjection view(const std::string& name, const Vec3& viewer, const Vec3& up = {0, 0, 1}) {
  return {name, orthographic(viewer, up)};
}

std::string format_dimensions(const std::vector<scene::DimensionDescription>& dimensions) {
  std::string text;
  for (const scene::DimensionDescription& one : dimensions)
    text += std::string(scene::word_of(*one.direction)) + ' ' + *one.view + ' ';
  return text;
}

TEST(OverallDimensions, EachOnceInTheClearestView) {
  const sheet::NamedProjection front = view("front", from_front), top = view("top", {0, 0, 1}, {0, 1, 0}),
                               left = view("left", from_left), corner = view("corner", from_corner);
  const scene::DimensionDescription open = dimension("overall", {});
  const auto chosen = [&](const std::vector<sheet::NamedProjection>& views,
                          const scene::DimensionDescription& options) {
    const features::Extent length{0, 30};
    return format_dimensions(sheet::overall_dimensions(options, views, {length, length, length}));
  };
  EXPECT_EQ(chosen({corner, top, left, front}, open), "width front height front depth left ");
  EXPECT_EQ(chosen({front, top}, open), "width front height front depth top ");
  EXPECT_EQ(chosen({top}, open), "width top depth top ");
  EXPECT_EQ(chosen({left, corner}, open), "height left depth left ");
  scene::DimensionDescription at_the_left = open;
  at_the_left.view = {"left", "scene.toml:1:1"};
  EXPECT_EQ(chosen({front, top, left}, at_the_left), "height left depth left ");
  EXPECT_TRUE(contains(error_of([&] { chosen({corner}, open); }).what(), "no view shows"));
}

TEST(OverallDimensions, AShaftHasOneDiameter) {
  const std::vector<sheet::NamedProjection> views{view("front", from_front), view("top", {0, 0, 1}, {0, 1, 0})};
  const features::Extent shaft{-40, 40, features::ExtentForm::diameter, {0, 0, 0}, {0, 0, 1}};
  const features::Extent beside{-35, 45, features::ExtentForm::diameter, {0, 5, 0}, {0, 0, 1}};
  const scene::DimensionDescription open = dimension("overall", {});
  EXPECT_EQ(format_dimensions(sheet::overall_dimensions(open, views, {shaft, shaft, {0, 80}})),
            "width front height front ");
  EXPECT_EQ(format_dimensions(sheet::overall_dimensions(open, views, {shaft, beside, {0, 80}})),
            "width front height front depth top ");
}

// A slot along x leaves the outline of the front view narrower than the head.
TEST(OverallDimensions, ADiameterStandsWhereItsEndsAre) {
  const std::vector<sheet::NamedProjection> views{view("front", from_front), view("top", {0, 0, 1}, {0, 1, 0})};
  features::Extent across{-40, 40, features::ExtentForm::diameter, {0, 0, 0}, {0, 0, 1}};
  const features::Extent along = across;
  across.interrupted = true;
  EXPECT_EQ(format_dimensions(sheet::overall_dimensions(dimension("overall", {}), views, {across, along, {0, 80}})),
            "height front depth top ");
}

TEST(OverallDimensions, HaveTheRoomThatWasKeptFree) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const projection::Projection front = orthographic(from_front);
  const drawing::ViewDrawing drawing = drawing_of(world, front);
  const std::vector<scene::DimensionDescription> dimensions{dimension("overall", {}, "width"),
                                                            dimension("overall", {}, "height")};
  const sheet::Room room = sheet::dimension_room(dimensions, front, 3.5);
  EXPECT_EQ(room.before.x, room.after.x);
  EXPECT_EQ(room.after.y, 0);
  for (const sheet::Stroke& stroke : layer_of(world, drawing, dimensions).strokes) {
    for (const Vec2& p : stroke.points) {
      EXPECT_GE(p.y, drawing.box.min.y - room.before.y);
      EXPECT_LE(p.x, drawing.box.max.x + room.after.x);
    }
  }
  EXPECT_EQ(sheet::dimension_room({}, front, 3.5).before, Vec2(0, 0));
}

// A view on the right, 20 mm away: the height stands on the left; with another one there, a found one is left out.
TEST(DimensionPlaces, NothingIsInsideAnotherView) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const std::vector<scene::DimensionDescription> height{dimension("overall", {}, "height")};
  const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
  sheet::Neighbours around;
  const auto add_view = [&](const Vec2& min, const Vec2& max) {
    around.views.push_back(sheet::turned_box({min, max}));
    around.boxes.push_back(around.views.back());
  };
  add_view({132, 0}, {190, 200});
  const sheet::PlacedLayer left = sheet::place_dimensions({world, front, height, 1}, style, around);
  ASSERT_EQ(left.layer.texts.size(), 1U);
  EXPECT_LT(left.layer.texts[0].at.x, front.box.min.x);
  add_view({0, 0}, {68, 200});
  const sheet::PlacedLayer none = sheet::place_dimensions({world, front, height, 1}, style, around);
  EXPECT_EQ(none.left_out, (std::vector<std::size_t>{0}));
  EXPECT_TRUE(none.layer.texts.empty());
  // Who asks for it has it, and lint says where it stands.
  const sheet::PlacedLayer asked = sheet::place_dimensions({world, front, height}, style, around);
  EXPECT_EQ(asked.layer.texts.size(), 1U);
  EXPECT_TRUE(asked.has_conflicts);
}

// A diameter seen edge-on needs lines that lead away from the plane of its circle.
TEST(DimensionPlaces, SizesOfWhatIsNotShownAreLeftOut) {
  const world::World world = placed(cylinder(48, 10, 30));
  scene::DimensionDescription diameter = dimension("diameter", {});
  diameter.circle = {Vec3(0, 0, 30), Vec3(0, 0, 1), 10, {}};
  scene::DimensionDescription inner = diameter;
  inner.circle->radius = 5;
  const std::vector<scene::DimensionDescription> both{diameter, inner};
  const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
  for (const auto& projection : {orthographic(from_front), from_above()}) {
    const drawing::ViewDrawing seen = drawing_of(world, projection);
    const sheet::PlacedLayer placed = sheet::place_dimensions({world, seen, both, 2}, style);
    EXPECT_EQ(placed.unseen, (std::vector<std::size_t>{1})) << "nothing has a radius of 5";
    EXPECT_EQ(placed.layer.texts.size(), 1U);
    EXPECT_EQ(sheet::place_dimensions({world, seen, both, 0}, style).layer.texts.size(), 2U);
    EXPECT_TRUE(sheet::place_dimensions({world, seen, both, 2, true}, style).unseen.empty()) << "lines are missing";
  }
}

// A leader to the left hole of two, along the line through both, would go through the right one.
TEST(DimensionPlaces, LeadersGoThroughNoOtherHole) {
  const sheet::Disc other{{20, 0}, 5};
  EXPECT_TRUE(sheet::goes_through({{5, 0}, {40, 0}}, other));
  EXPECT_TRUE(sheet::goes_through({{5, 0}, {20, 2}}, other)) << "it ends in it";
  EXPECT_FALSE(sheet::goes_through({{5, 0}, {40, 30}}, other));
  EXPECT_FALSE(sheet::goes_through({{24, 3}, {40, 30}}, other)) << "it begins on it";
  EXPECT_FALSE(sheet::goes_through({{5, 0}, {40, 0}}, {{0, 0}, 50})) << "all is in it";
}

// The outline of a plate turns around a fillet of radius 2, inside of which three studs leave no way for a leader.
TEST(DimensionPlaces, LeadersToFilletsComeFromTheOpenSide) {
  Shape part;
  std::vector<Vec2> outline{{-40, -40}, {40, -40}, {40, 0}};
  std::vector<Vec3> arc;
  for (int i = 0; i <= 8; ++i) {
    const double angle = -std::numbers::pi / 2 * (1 + i / 8.0);
    arc.emplace_back(2 + 2 * std::cos(angle), 2 + 2 * std::sin(angle), 5);
  }
  for (const Vec3& p : arc) outline.emplace_back(p);
  for (const Vec2& p : {Vec2(0, 40), Vec2(-40, 40)}) outline.push_back(p);
  const int corners = static_cast<int>(outline.size());
  std::vector<int> bottom, top;
  for (int i = 0; i < 2 * corners; ++i) {
    const Vec2& corner = outline[static_cast<std::size_t>(i % corners)];
    part.points.push_back({corner.x, corner.y, i < corners ? 0.0 : 5.0});
    if (i < corners) {
      part.faces.push_back({i, (i + 1) % corners, corners + (i + 1) % corners, corners + i});
      bottom.insert(bottom.begin(), i);
    } else {
      top.push_back(i);
    }
  }
  part.faces.push_back(bottom);
  part.faces.push_back(top);
  for (const double degrees : {195.0, 225.0, 255.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    part.add(cylinder(32, 3.9, 3).moved(2 + 12 * std::cos(angle), 2 + 12 * std::sin(angle), 5));
  }
  const world::World world = placed(part);
  const drawing::ViewDrawing above = drawing_of(world, from_above());
  const std::vector<sheet::Disc> studs = sheet::discs_of(above);
  ASSERT_EQ(studs.size(), 3U);
  scene::DimensionDescription fillet = dimension("radius", {});
  fillet.circle = {Vec3(2, 2, 5), Vec3(0, 0, 1), 2, arc};
  const sheet::Layer layer = layer_of(world, above, {fillet});
  const std::vector<Vec2>& leader = layer.strokes.at(0).points;
  ASSERT_GE(leader.size(), 2U);
  for (const sheet::Disc& stud : studs) {
    EXPECT_FALSE(sheet::goes_through({leader[0], leader[1]}, stud));
    EXPECT_FALSE(sheet::goes_through({leader[1], leader[0]}, stud));
  }
}

}  // namespace
}  // namespace epura::test::dimension_places_test
