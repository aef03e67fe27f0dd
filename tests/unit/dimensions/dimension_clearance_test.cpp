// SPDX-License-Identifier: Apache-2.0
// How far dimensions keep from each other, and from what they could be taken for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dimensions/forms.hpp"
#include "dimensions/obstacles.hpp"
#include "dimensions/straight.hpp"
#include "dimensions_support.hpp"

namespace epura::test::dimension_clearance_test {
namespace {

// The leader to a pitch circle must not end in one of its holes.
TEST(DimensionClearance, LeadersSeemToMeanSmallHoles) {
  EXPECT_TRUE(sheet::goes_through({{20, 0}, {40, 30}}, {{20.2, 0}, 1}));
  EXPECT_FALSE(sheet::goes_through({{21.2, 0}, {40, 30}}, {{20.2, 0}, 1})) << "its own";
  EXPECT_FALSE(sheet::goes_through({{20, 0}, {40, 30}}, {{20.2, 0}, 4})) << "as large as to be told from the arrow";
}

// The upright lines of a layer that are beside each other, at least in part: the smallest distance between them.
double nearest_upright_lines(const sheet::Layer& layer) {
  double nearest = HUGE_VAL;
  std::vector<std::array<Vec2, 2>> upright;
  for (const sheet::Stroke& stroke : layer.strokes)
    if (const Vec2& a = stroke.points.front(), &b = stroke.points.back(); std::abs(a.x - b.x) < 1e-6)
      upright.push_back({a.y < b.y ? a : b, a.y < b.y ? b : a});
  for (const auto& [from, to] : upright)
    for (const auto& [begin, end] : upright)
      if (std::abs(from.x - begin.x) > 1e-6 && std::max(from.y, begin.y) < std::min(to.y, end.y))
        nearest = std::min(nearest, std::abs(from.x - begin.x));
  return nearest;
}

// Two steps half a millimetre apart on paper: their extension lines are on different sides.
TEST(DimensionClearance, ExtensionLinesOfDifferentPlacesAreApart) {
  for (const double apart : {0.3, 0.5, 0.6, -0.3, -0.5}) {
    Shape steps = box({0, 0, 0}, {60, 10, 20});
    steps.add(box({0, 0, 20}, {30, 10, 30}));
    steps.add(box({0, 0, 30}, {30 - apart, 10, 40}));
    const world::World world = placed(steps);
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
    std::vector<scene::DimensionDescription> dimensions;
    for (const Vec3& end : {Vec3(30, 0, 30), Vec3(30 - apart, 0, 40)}) {
      dimensions.push_back(dimension("linear", {0, 0}, "horizontal"));
      dimensions.back().anchors = {Vec3(0, 0, 0), end};
    }
    const sheet::Layer layer = layer_of(world, front, dimensions);
    ASSERT_EQ(layer.texts.size(), 2U);
    EXPECT_GE(nearest_upright_lines(layer), 0.7) << apart;
  }
}

// Posts stand around the first of two equal holes, closer together than a leader is wide.
TEST(DimensionClearance, ANoteStandsAtAnotherEqualCircle) {
  for (const double way : {1.0, -1.0}) {
    Shape part = cylinder(48, 3, 5);
    for (int i = 0; i < 12; ++i) {
      const double angle = 2 * std::numbers::pi * i / 12;
      part.add(cylinder(32, 2, 5).moved(7.5 * std::cos(angle), 7.5 * std::sin(angle), 0));
    }
    part.add(cylinder(48, 3, 5).moved(way * 40, 5, 0));
    const world::World world = placed(part);
    const drawing::ViewDrawing above = drawing_of(world, from_above());
    scene::DimensionDescription note = dimension("diameter", {});
    note.circle = {Vec3(0, 0, 5), Vec3(0, 0, 1), 3, {}};
    note.text = {"2× <>", ""};
    const auto centre_of_tip = [&](const sheet::Layer& layer) {
      const Vec2 tip = layer.fills.at(0).rings.at(0).at(0);
      const auto on_paper = [&](const Vec3& p) { return drawing::position_on_page(above, p); };
      return glm::distance(tip, on_paper({0, 0, 5})) < 10 ? 0 : 1;
    };
    const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
    const std::vector<std::vector<scene::FeatureCircle>> equal{{{Vec3(way * 40, 5, 5), Vec3(0, 0, 1), 3, {}}}};
    const auto place = [&](std::span<const std::vector<scene::FeatureCircle>> others) {
      return sheet::place_dimensions({world, above, {&note, 1}, 1, false, others}, style);
    };
    EXPECT_EQ(centre_of_tip(place({}).layer), 0);
    const sheet::PlacedLayer placed = place(equal);
    EXPECT_EQ(centre_of_tip(placed.layer), 1);
    ASSERT_EQ(placed.layer.texts.size(), 1U);
    EXPECT_EQ(placed.layer.texts[0].text, "2× ⌀6");
    // Where the view does not show the first, the note is at one that it shows.
    note.circle->centre = Vec3(0, 60, 5);
    EXPECT_TRUE(place(equal).unseen.empty());
    EXPECT_EQ(place({}).unseen.size(), 1U);
  }
}

// The upper edge of a plate is where the shoulder of the best leader would be.
TEST(DimensionClearance, ShouldersDoNotRunAlongLines) {
  for (const double off : {-0.8, -0.4, 0.0, 0.3, 0.5, 0.6, 0.8}) {
    const double edge = 11 / std::sqrt(2.0) + off;
    Shape part = box({-30, -30, 0}, {30, edge, 5});
    part.add(cylinder(48, 3, 5).moved(0, 0, 5));
    const world::World world = placed(part);
    const drawing::ViewDrawing above = drawing_of(world, from_above());
    scene::DimensionDescription note = dimension("diameter", {});
    note.circle = {Vec3(0, 0, 10), Vec3(0, 0, 1), 3, {}};
    const sheet::Layer layer = layer_of(world, above, {note});
    const double line = drawing::position_on_page(above, {0, edge, 5}).y;
    for (const sheet::Stroke& stroke : layer.strokes) {
      if (stroke.points.size() != 3) continue;
      EXPECT_GE(std::abs(stroke.points[2].y - line), 0.9) << off;
    }
  }
}

// Collars of any size at both ends of a neck, or at one.
TEST(DimensionClearance, ExtensionLinesOfADiameterDoNotGoThroughThePart) {
  for (int i = 0; i < 24; ++i) {
    const double length = 6 + 2 * i, neck = 5 + i % 7, low = neck + 1 + i % 5;
    const bool is_free = i % 3 == 0;  // above
    Shape part = cylinder(48, low, 10);
    part.add(cylinder(48, neck, length).moved(0, 0, 10));
    part.add(cylinder(48, is_free ? neck - 2 : neck + 2 + i % 4, 8).moved(0, 0, 10 + length));
    const world::World world = placed(part);
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
    scene::DimensionDescription note = dimension("diameter", {});
    note.circle = {Vec3(0, 0, 10), Vec3(0, 0, 1), neck, {}};
    sheet::Neighbours around;
    std::vector<sheet::TurnedBox>& boxes = around.boxes;
    boxes.push_back(sheet::line_box({100, front.box.min.y - 3}, {100, front.box.max.y + 3}));  // the centre line
    const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
    const sheet::PlacedLayer placed = sheet::place_dimensions({world, front, {&note, 1}, 1}, style, around);
    ASSERT_EQ(placed.layer.texts.size(), 1U) << i;
    const double begin = drawing::position_on_page(front, {0, 0, 10}).y;
    for (const Vec2& tip : tips(placed.layer)) {
      EXPECT_NEAR(std::abs(tip.x - 100), neck, 1e-6) << i;
      if (is_free) {
        EXPECT_GT(tip.y, front.box.max.y) << i;
      } else {
        EXPECT_TRUE(tip.y > begin && tip.y < begin + length) << i;
      }
    }
    EXPECT_EQ(placed.layer.strokes.size(), is_free ? 3U : 1U) << i << ": lines of the outline are extension lines";
  }
}

// Of lengths in any direction, narrow ones and those wider than their text.
TEST(DimensionClearance, TextsOnLeadersAreBesideTheirOwnLines) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const sheet::Lettering lettering;
  const sheet::DimensionStyle style{lettering, 0.25};
  std::size_t count = 0;
  for (int i = 0; i < 24; ++i) {
    const double angle = i % 4 * std::numbers::pi / 8, size = 1 + 1.5 * i;
    scene::DimensionDescription one = dimension("aligned", {});
    one.anchors = {Vec3(20, 0, 10), Vec3(20 + size * std::cos(angle), 0, 10 + size * std::sin(angle))};
    const sheet::MeasuredDimension measured =
        sheet::measure(front, sheet::find_anchors(world, {&one, 1})[0], style.notation);
    for (sheet::ItemPlacement& there :
         sheet::placements_in_crowd(std::get<sheet::MeasuredLength>(measured.form), measured, front, style)) {
      const auto place = there.drawn();
      if (place->leaders.empty()) continue;
      ++count;
      for (const sheet::Stroke& stroke : place->strokes)
        if (stroke.points.size() == 2) {
          EXPECT_FALSE(sheet::overlap(place->text_boxes.at(0), sheet::line_box(stroke.points[0], stroke.points[1])))
              << size << " at " << i % 4 * 22.5;
        }
    }
  }
  EXPECT_GT(count, 1000U);
}

// The room between a dimension line of another view and the top of its text is that dimension's.
TEST(DimensionClearance, NoTextIsAmongDimensionsOfAnotherView) {
  const world::World world = placed(box({0, 0, 0}, {60, 10, 40}));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const std::vector<scene::DimensionDescription> width{dimension("overall", {}, "width")};
  const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
  const sheet::PlacedLayer alone = sheet::place_dimensions({world, front, width, 1}, style);
  ASSERT_EQ(alone.layer.texts.size(), 1U);
  EXPECT_LT(alone.layer.texts[0].at.y, front.box.min.y);
  sheet::Neighbours around;
  around.zones = {sheet::turned_box({{0, 60}, {200, 79}})};
  const sheet::PlacedLayer moved = sheet::place_dimensions({world, front, width, 1}, style, around);
  ASSERT_EQ(moved.layer.texts.size(), 1U);
  EXPECT_GT(moved.layer.texts[0].at.y, front.box.max.y);
  for (const sheet::TurnedBox& zone : moved.zones) EXPECT_FALSE(sheet::overlap(zone, around.zones[0]));
  EXPECT_FALSE(moved.zones.empty());
  around.zones.push_back(sheet::turned_box({{0, 121}, {200, 900}}));
  around.zones.push_back(sheet::turned_box({{0, -900}, {200, 79}}));
  const sheet::PlacedLayer none = sheet::place_dimensions({world, front, width, 1}, style, around);
  EXPECT_EQ(none.left_out, (std::vector<std::size_t>{0}));
}

// Of a disc with a keyway in any direction.
TEST(DimensionClearance, LeadersEndWhereTheirCircleIsDrawn) {
  constexpr double radius = 20, half = 20;  // degrees to either side of the middle of the keyway
  constexpr int corners = 72;
  for (int middle = 0; middle < 360; middle += 15) {
    const auto at = [](double r, double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return Vec2(r * std::cos(angle), r * std::sin(angle));
    };
    std::vector<Vec2> outline;
    for (int i = 0; i < corners; ++i) {
      const double angle = middle + half + (360 - 2 * half) * i / (corners - 1);
      outline.push_back(at(radius, angle));
    }
    for (const double side : {-1.0, 1.0}) outline.push_back(at(0.7 * radius, middle + side * half));
    Shape disc;
    for (const double z : {0.0, 8.0})
      for (const Vec2& p : outline) disc.points.push_back({p.x, p.y, z});
    const int count = static_cast<int>(outline.size());
    std::vector<int> bottom, top;
    for (int i = 0; i < count; ++i) {
      disc.faces.push_back({i, (i + 1) % count, count + (i + 1) % count, count + i});
      bottom.insert(bottom.begin(), i);
      top.push_back(count + i);
    }
    disc.faces.push_back(bottom);
    disc.faces.push_back(top);
    const world::World world = placed(disc);
    const drawing::ViewDrawing view = drawing_of(world, from_above());
    scene::DimensionDescription diameter = dimension("diameter", {});
    diameter.circle = scene::FeatureCircle{{0, 0, 8}, {0, 0, 1}, radius, {}};
    const Vec2 box_middle = (view.box.min + view.box.max) / 2.0;
    ASSERT_LT(glm::distance(box_middle, Vec2(100, 100)), 1e-6);
    const Vec2 centre = drawing::position_on_page(view, Vec3(0, 0, 8));
    const sheet::Layer layer = layer_of(world, view, {diameter});
    ASSERT_GE(layer.fills.size(), 1U);
    for (const sheet::Fill& arrow : layer.fills) {
      const Vec2 tip = arrow.rings[0][0] - centre, gap = at(1, middle);
      EXPECT_NEAR(glm::length(tip), radius, 1e-6);
      EXPECT_LT(glm::dot(glm::normalize(tip), gap), std::cos(half * std::numbers::pi / 180) + 1e-6) << middle;
    }
  }
}

// Round posts stand on a circle, also where leaders lean by 45 degrees.
TEST(DimensionClearance, LeadersToPitchCirclesEndBetweenTheHoles) {
  constexpr double pitch = 40, radius = 5;
  for (const int count : {2, 4, 8, 12}) {
    Shape posts;
    std::vector<Vec2> centres;
    for (int i = 0; i < count; ++i) {
      const double angle = std::numbers::pi / 4 + 2 * std::numbers::pi * i / count;
      centres.emplace_back(pitch * std::cos(angle), pitch * std::sin(angle));
      posts.add(cylinder(24, radius, 5).moved(centres.back().x, centres.back().y, 0));
    }
    const world::World world = placed(posts);
    const drawing::ViewDrawing view = drawing_of(world, from_above());
    scene::DimensionDescription diameter = dimension("diameter", {});
    diameter.circle = scene::FeatureCircle{{0, 0, 5}, {0, 0, 1}, pitch, {}};
    const Vec2 centre = drawing::position_on_page(view, Vec3(0, 0, 5));
    for (const sheet::Fill& arrow : layer_of(world, view, {diameter}).fills)
      for (const Vec2& hole : centres) EXPECT_GT(glm::distance(arrow.rings[0][0] - centre, hole), radius) << count;
  }
}

// A wall hides most of the rim of a disc.
TEST(DimensionClearance, LeadersEndWhereAnEllipseIsSeen) {
  for (const double wall : {-9.0, -4.0, 0.0}) {
    Shape part = cylinder(48, 10, 5);
    part.add(box({-40, -60, 0}, {60, wall, 12}));
    const world::World world = placed(part);
    const drawing::ViewDrawing view = drawing_of(world, orthographic(from_corner));
    scene::DimensionDescription diameter = dimension("diameter", {});
    diameter.circle = scene::FeatureCircle{{0, 0, 5}, {0, 0, 1}, 10, {}};
    const sheet::Layer layer = layer_of(world, view, {diameter});
    ASSERT_EQ(layer.fills.size(), 1U);
    const Vec2 tip = layer.fills[0].rings[0][0];
    double nearest = HUGE_VAL;
    for (const drawing::Segment& segment : view.segments) {
      if (!segment.visible) continue;
      const Vec2 along = segment.to - segment.from;
      const double at = std::clamp(glm::dot(tip - segment.from, along) / glm::dot(along, along), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(tip, segment.from + at * along));
    }
    EXPECT_LT(nearest, 0.05) << wall;
  }
}

// Axonometric views measure along their axes, at 60 degrees to each other on paper.
TEST(DimensionClearance, TextsAreClearOfLeaningExtensionLines) {
  const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
  const sheet::DimensionText text("4× 25");
  const Vec2 along(0.5 * std::sqrt(3), 0.5);
  for (const Vec2& extension : {Vec2(along.x, -along.y), Vec2(0, 1), Vec2(-along.y, along.x)})
    for (const double size : {40.0, 18.0, 6.0})
      for (const double distance : {12.0, -12.0}) {
        const sheet::MeasuredLength length{{0, 0}, size * along, along, extension};
        std::vector<sheet::PlacedDimension> all;
        for (int place = 0; place < sheet::text_places; ++place)
          all.push_back(sheet::straight_dimension(length, text, distance, place, style));
        for (const bool at_high : {true, false})
          all.push_back(sheet::straight_dimension_beside(length, text, distance, {at_high, 0}, style));
        for (const sheet::PlacedDimension& one : all)
          for (const sheet::Stroke& line : one.strokes)
            EXPECT_FALSE(sheet::overlap(one.text_boxes.at(0), sheet::line_box(line.points.front(), line.points.back())))
                << extension.x << ' ' << extension.y << ", " << size << " at " << distance;
      }
}

// 40 from the corner of an angle of 60 degrees, whose legs are 20 long, a post stands in the way of one of them.
TEST(DimensionClearance, LegsOfAnglesDoNotGoThroughThePart) {
  const auto costs = [](double post) {
    Shape part = box({0, -5, -10}, {1, 5, 0});
    part.add(box({post, -5, 0}, {post + 4, 5, 60}));
    const world::World world = placed(part);
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
    const Vec2 corner = drawing::position_on_page(front, Vec3(0));
    const sheet::MeasuredAngle angle{corner, {Vec2(20, 0), 20.0 * Vec2(0.5, std::sqrt(0.75))}};
    std::vector<double> found;
    for (const auto& one :
         sheet::placements_of(angle, {angle, sheet::DimensionText("60°"), {}}, front, {sheet::Lettering(), 0.25}))
      found.push_back(one.cost);
    return found;
  };
  const std::vector<double> blocked = costs(20), free = costs(-40);
  ASSERT_EQ(blocked.size(), free.size());
  EXPECT_EQ(blocked.front(), free.front());
  EXPECT_GE(blocked.back(), free.back() + 20);
}

// The rim of a wider disc lies near the hidden one of a shaft, and looks like it on paper.
TEST(DimensionClearance, LeadersOfAxonometricViewsEndOnTheirOwnFeature) {
  constexpr double radius = 17.5;
  Shape part = cylinder(72, radius, 30);
  part.add(cylinder(72, 1.1 * radius, 10).moved(0, 0, 30));
  const world::World world = placed(part);
  drawing::ViewDrawing view = drawing_of(world, orthographic(from_corner));
  std::erase_if(view.segments, [](const drawing::Segment& segment) { return !segment.visible; });
  std::vector<scene::DimensionDescription> diameter{dimension("diameter", {})};
  diameter[0].circle = scene::FeatureCircle{{0, 0, 30}, {0, 0, 1}, radius, {}};
  const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
  EXPECT_EQ(sheet::place_dimensions({world, view, diameter, 1}, style).unseen, (std::vector<std::size_t>{0}));
  const std::vector<std::vector<scene::FeatureCircle>> other_end{{{{0, 0, 0}, {0, 0, 1}, radius, {}}}};
  const sheet::PlacedLayer placed_there = sheet::place_dimensions({world, view, diameter, 1, false, other_end}, style);
  ASSERT_EQ(placed_there.layer.fills.size(), 1U);
  const Vec2 tip = placed_there.layer.fills[0].rings[0][0];
  double nearest = HUGE_VAL;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * std::numbers::pi / 360;
    const Vec3 rim = radius * Vec3(std::cos(angle), std::sin(angle), 0);
    nearest = std::min(nearest, glm::distance(tip, drawing::position_on_page(view, rim)));
  }
  EXPECT_LT(nearest, 0.1);
}

// A length says where a bore is, of which the view shows the mouth or not.
TEST(DimensionClearance, PlacesOfWhatIsNotSeenAreLeftOut) {
  Shape part = cylinder(48, 5, 10);
  part.add(box({-20, -20, -10}, {20, 20, 0}));
  const world::World world = placed(part);
  const drawing::ViewDrawing view = drawing_of(world, orthographic(from_corner));
  std::vector<scene::DimensionDescription> place{dimension("aligned", {})};
  place[0].anchors = {Vec3(-20, 0, 10), Vec3(0, 0, 10)};
  const sheet::DimensionStyle style{sheet::Lettering(), 0.25};
  for (const double height : {10.0, -10.0}) {
    const std::vector<std::vector<scene::FeatureCircle>> rim{{{{0, 0, height}, {0, 0, 1}, 5, {}}}};
    EXPECT_EQ(sheet::place_dimensions({world, view, place, 1, false, rim}, style).unseen.empty(), height > 0) << height;
  }
}

// Between parallel faces, an angle is at either end of a slope: slats are in the way at one of them.
TEST(DimensionClearance, AnglesStandWhereTheirLegsAreFree) {
  const Vec2 slope(10, 20 * std::sqrt(0.75));
  const auto tip_with = [&](int slats) {
    Shape part = box({0, -5, -10}, {1, 5, 0});
    for (int i = 0; i < slats; ++i) part.add(box({12.0 + i, -5, 1}, {12.5 + i, 5, 1.7 * (12 + i) - 2}));
    const world::World world = placed(part);
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
    const Vec2 corner = drawing::position_on_page(front, Vec3(0));
    sheet::MeasuredAngle angle{corner, {Vec2(12, 0), slope}};
    angle.equal = sheet::CornerOnPaper{corner + slope, {Vec2(-1, 0), -slope}};
    auto all = sheet::placements_of(angle, {angle, sheet::DimensionText("60°"), {}}, front, {sheet::Lettering(), 0.25});
    return std::ranges::min_element(all, {}, &sheet::ItemPlacement::cost)->drawn()->arrows.at(0).rings[0][0] - corner;
  };
  EXPECT_NEAR(tip_with(0).y, 0, 1e-6);
  EXPECT_GT(tip_with(0).x, 0);
  EXPECT_NEAR(tip_with(40).y, slope.y, 1e-6);
  EXPECT_LT(tip_with(40).x, slope.x);
}

}  // namespace
}  // namespace epura::test::dimension_clearance_test
