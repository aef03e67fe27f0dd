// SPDX-License-Identifier: Apache-2.0
// Holes of which notes say all sizes, and places that no face has as its direction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "dimensioned_part.hpp"
#include "sizes/stated_values.hpp"
#include "turned_parts.hpp"

namespace epura::test::noted_holes_test {
namespace {

/// Where a round hole has which radius.
struct Ring {
  double radius, z;
};

constexpr double thickness = 10;

const Vec2 hole_at(25, 18);

// A plate of 60 x 40 above a height, with a hole from its top down; one that is not through ends in a point.
void add_plate(Model& model, double floor, const std::vector<Ring>& rings, bool is_through) {
  const Loop border = square({0, 0}, {60, 40});
  std::vector<Loop> holes;
  for (const Ring& ring : rings) holes.push_back(circle(hole_at, ring.radius, -135));
  const Vec3 up(0, 0, floor);
  const auto at = [&](std::size_t ring, std::size_t p) {
    return up + (ring == rings.size() ? Vec3(hole_at, 3) : Vec3(holes[ring][p], rings[ring].z));
  };
  const auto side = [&](std::size_t p, double z) { return up + Vec3(border[p], z); };
  std::vector<Vec3> bottom;
  for (std::size_t p = 0; p < border.size(); ++p) {
    const std::size_t q = (p + 1) % border.size(), last = rings.size() - 1;
    model.face({side(p, thickness), side(q, thickness), at(0, q), at(0, p)});
    for (std::size_t ring = 0; ring + 1 < rings.size() + (is_through ? 0 : 1); ++ring)
      model.face({at(ring, p), at(ring, q), at(ring + 1, q), at(ring + 1, p)});
    model.face({side(q, thickness), side(p, thickness), side(p, 0), side(q, 0)});
    if (is_through) model.face({at(last, p), at(last, q), side(q, 0), side(p, 0)});
    bottom.insert(bottom.begin(), side(p, 0));
  }
  if (!is_through) model.face(bottom);
}

std::string plate_with(const std::vector<Ring>& rings, bool is_through) {
  Model model;
  add_plate(model, 0, rings, is_through);
  return model.obj();
}

// A block of 60 along its slope, which rises by 20 degrees, with a hole square to it that leaves the level floor.
std::string wedge_with_hole() {
  const double c = std::cos(20 / 180.0 * std::numbers::pi), s = std::sin(20 / 180.0 * std::numbers::pi);
  const Loop border = square({0, 0}, {60, 40}), round = circle(hole_at, 3, -135);
  const auto in_world = [&](const Vec2& p, const Vec3& down) { return Vec3(p.x * c, p.y, 10 + p.x * s) + down; };
  const auto high = [&](const Vec2& p) { return in_world(p, Vec3(0)); };
  const auto low = [&](const Vec2& p) { return in_world(p, Vec3(0, 0, -10 - p.x * s)); };
  const auto out = [&](const Vec2& p) { return in_world(p, (10 + p.x * s) / c * Vec3(s, 0, -c)); };
  Model model;
  for (std::size_t p = 0; p < border.size(); ++p) {
    const std::size_t q = (p + 1) % border.size();
    model.face({high(border[p]), high(border[q]), high(round[q]), high(round[p])});
    model.face({high(round[p]), high(round[q]), out(round[q]), out(round[p])});
    model.face({high(border[q]), high(border[p]), low(border[p]), low(border[q])});
    model.face({out(round[p]), out(round[q]), low(border[q]), low(border[p])});
  }
  return model.obj();
}

// From the height where a bore of 6 ends to that of its drill point.
const double point = 3 / std::tan(59 / 180.0 * std::numbers::pi);

// A plate of 20 with holes drilled 10 deep, and a slot of their radius that is as deep.
std::string drilled_plate_with_slot() {
  Plate plate(20);
  for (const double x : {0.0, 40.0}) {
    const Vec2 at(x + 20, 15);
    plate.cell(square({x, 0}, {40, 30}),
               {{circle(at, 3, -135), 20}, {circle(at, 3, -135), 10}, {circle(at, 0, -135), 10 - point}});
  }
  const Loop end = slot({100, 15}, 3, 12);
  plate.cell(square({80, 0}, {40, 30}), {{end, 20}, {end, 10}});
  return plate.obj();
}

// A plate of 30, drilled 10 deep from both sides on one axis.
std::string plate_drilled_from_both_sides() {
  const Loop border = square({0, 0}, {60, 40}), round = circle(hole_at, 3, -135);
  Model model;
  for (std::size_t p = 0; p < border.size(); ++p) {
    const std::size_t q = (p + 1) % border.size();
    model.face({Vec3(border[q], 30), Vec3(border[p], 30), Vec3(border[p], 0), Vec3(border[q], 0)});
    for (const bool is_up : {true, false}) {
      const std::size_t a = is_up ? p : q, b = is_up ? q : p;
      const double top = is_up ? 30 : 0, floor = is_up ? 20 : 10, tip = is_up ? 20 - point : 10 + point;
      model.face({Vec3(border[a], top), Vec3(border[b], top), Vec3(round[b], top), Vec3(round[a], top)});
      model.face({Vec3(round[a], top), Vec3(round[b], top), Vec3(round[b], floor), Vec3(round[a], floor)});
      model.face({Vec3(round[a], floor), Vec3(round[b], floor), Vec3(hole_at, tip)});
    }
  }
  return model.obj();
}

// What automatic dimensions of a part are, with `holes`, in views of which the first may be a section.
sheet::AutomaticPlan plan_of(const world::World& world, HoleDimensions holes,
                             const std::vector<sheet::NamedProjection>& views) {
  features::PartFeatures features = features::features_to_dimension(world);
  features.of_assembly = false;
  scene::DimensionDescription wanted;
  wanted.type = {DimensionType::automatic, ""};
  wanted.holes = {holes, ""};
  return sheet::automatic_dimensions(wanted, views, {world, features, features::true_extents(world)}, {}, std::nullopt);
}

// Of lint and of define, one word for each fault.
std::string faults_of(const DimensionedPart& part) {
  const Said free = part.free();
  std::string text;
  for (const sheet::FreeFace& one : free.free) text += one.sentence + "\n";
  for (const std::string& one : free.undecided) text += one + "\n";
  const auto rebuilt = part.rebuilt();
  if (!rebuilt || !rebuilt->is_defined()) text += "not found again\n";
  return text;
}

bool has(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

std::size_t number_of(const DimensionedPart& part, const std::string& text) {
  const auto at = std::find(part.texts.begin(), part.texts.end(), text);
  EXPECT_NE(at, part.texts.end()) << testing::PrintToString(part.texts);
  return static_cast<std::size_t>(at - part.texts.begin());
}

}  // namespace

// The plate is as thick as the countersink is wide: only the sign tells which is meant.
TEST(NotedHoles, OfCountersinksAreHeldByDiameterAndAngle) {
  const DimensionedPart part(plate_with({{5, 10}, {2.5, 7.5}, {2.5, 0}}, true));
  ASSERT_TRUE(has(part.texts, "<> ⌵⌀10×90°")) << testing::PrintToString(part.texts);
  EXPECT_EQ(faults_of(part), "");
}

TEST(NotedHoles, OfDrillPointsAreHeldByTheirDepth) {
  for (const HoleDimensions holes : {HoleDimensions::notes, HoleDimensions::table})
    EXPECT_EQ(faults_of(DimensionedPart(plate_with({{3, 10}, {3, 3 + point}}, false), holes)), "");
}

// Its floor is as far from the bottom of the plate as from the top: a depth goes along the wall of its diameter.
TEST(NotedHoles, OfCounterboresAreHeldByDiameterAndDepth) {
  for (const HoleDimensions holes : {HoleDimensions::notes, HoleDimensions::table})
    EXPECT_EQ(faults_of(DimensionedPart(plate_with({{5, 10}, {5, 5}, {2.5, 5}, {2.5, 0}}, true), holes)), "");
}

// The ends of the slot have the radius and the depth of the holes, but they are none.
TEST(NotedHoles, AreCountedWithoutEndsOfSlots) {
  const DimensionedPart part(drilled_plate_with_slot());
  ASSERT_TRUE(has(part.texts, "2× <> ↧10")) << testing::PrintToString(part.texts);
  EXPECT_EQ(faults_of(part), "");
}

// "2×" of three equal holes, of which the third has a tolerance of its own.
TEST(NotedHoles, AreCountedWithoutThoseThatHaveADimensionOfTheirOwn) {
  Plate plate(10);
  for (const double x : {0.0, 40.0, 80.0}) {
    const Loop hole = circle({x + 20, 15}, 3, -135);
    plate.cell(square({x, 0}, {40, 30}), {{hole, 10}, {hole, 0}});
  }
  const DimensionedPart part(plate.obj());
  const std::size_t number = number_of(part, "3× <>");
  EXPECT_FALSE(part.with_text(number, "2× ⌀6", false).undecided.empty());
  // The note is at one of the holes; the tolerance is at each of the others in turn, or at the same.
  int complete = 0;
  for (const double x : {20.0, 60.0, 100.0}) {
    const Said faces = part.with_second(number, "2× ⌀6", [x](sheet::AnchoredDimension& other) {
      other.text = "⌀6 ±0.1";
      other.circles.front().centre = Vec3(x, 15, 10);
    });
    EXPECT_TRUE(faces.untrue.empty());
    if (faces.free.empty() && faces.undecided.empty()) ++complete;
  }
  EXPECT_EQ(complete, 2);
}

// Without the count, the note means the hole that the view looks into.
TEST(NotedHoles, FromBothSidesOnOneAxisAreTwo) {
  const DimensionedPart part(plate_drilled_from_both_sides());
  const std::size_t number = number_of(part, "2× <> ↧10");
  EXPECT_EQ(faults_of(part), "");
  const Said one = part.with_text(number, "⌀6 ↧10", false);
  EXPECT_TRUE(one.undecided.empty()) << testing::PrintToString(one.undecided);
  EXPECT_EQ(one.free.size(), 1U);
}

// Ten of twelve on a circle: two are on a centre line, so eight angles are all.
TEST(NotedHoles, OnCentreLinesNeedNoAngle) {
  Plate plate(10);
  for (const double middle : {0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0, 210.0, 240.0, 270.0, 300.0, 330.0}) {
    const auto at = [](double radius, double angle) { return radius * Vec2(cosine(angle), sine(angle)); };
    Loop sector = square({20, middle - 15}, {70, 30});
    for (Vec2& p : sector) p = at(p.x, p.y);
    const Loop hole = circle(at(55, middle), 4, middle - 135);
    plate.cell(sector, middle == 0 || middle == 180 ? Hole() : Hole{{hole, 10}, {hole, 0}});
  }
  const DimensionedPart part(plate.obj());
  number_of(part, "8× <>");
  EXPECT_EQ(faults_of(part), "");
}

// What files give as theoretically exact is the place of a zone or of a datum target, where no face need be: it does
// not leave open whether a face can move.
TEST(NotedHoles, ExactPlacesAreNoneOfFaces) {
  const DimensionedPart part(plate_with({{3, 10}, {3, 0}}, true));
  for (const bool is_exact : {false, true}) {
    const Said faces = part.with_second(number_of(part, ""), "(<>)", [is_exact](sheet::AnchoredDimension& other) {
      other.type = DimensionType::linear;
      other.direction = DimensionDirection::horizontal;
      other.points = {{7, 0, 3}, {13, 0, 3}};
      other.is_exact = is_exact;
    });
    EXPECT_EQ(faces.undecided.empty(), is_exact) << testing::PrintToString(faces.undecided);
    EXPECT_EQ(faces.free.empty(), !is_exact);
  }
}

// Along the slope on which it begins, wherever it ends.
TEST(NotedHoles, ThroughASlopeHaveAPlaceOnIt) { EXPECT_EQ(faults_of(DimensionedPart(wedge_with_hole())), ""); }

// Two plates behind each other, with a hole through both.
TEST(NotedHoles, OnOneAxisAreOneRowOfATable) {
  Model model;
  for (const double floor : {0.0, 30.0}) add_plate(model, floor, {{3, thickness}, {3, 0}}, true);
  const sheet::AutomaticPlan plan = plan_of(world_of(model.obj()), HoleDimensions::table, three_views());
  ASSERT_EQ(plan.tables.size(), 1U);
  ASSERT_EQ(plan.tables[0].rows.size(), 1U);
  EXPECT_EQ(plan.tables[0].rows[0].label, "A1");
  EXPECT_EQ(plan.tables[0].rows[0].size, "2× ⌀6");
}

// A blind hole in the top, which the view from above lacks: its size and its place are elsewhere.
TEST(NotedHoles, ThatASectionHasRemovedAreNotedElsewhere) {
  const world::World world = world_of(plate_with({{3, 10}, {3, 6}}, false));
  std::vector<sheet::NamedProjection> views = three_views();
  const cut::CuttingSurface section =
      cut::plane_surface({Vec3(0, 0, 2), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, 1, 0), "A", ""});
  for (const bool is_cut : {false, true}) {
    views[1].section = is_cut ? &section : nullptr;
    std::vector<std::string> noted;
    int placed = 0;
    for (const scene::DimensionDescription& one : plan_of(world, HoleDimensions::notes, views).dimensions) {
      if (*one.type == DimensionType::diameter) noted.push_back(*one.view);
      if (*one.type == DimensionType::linear && *one.view == "top") ++placed;
    }
    EXPECT_EQ(noted, std::vector<std::string>{is_cut ? "front" : "top"});
    EXPECT_EQ(placed, is_cut ? 0 : 2) << "along x and y";
  }
}

// With the decimals of the file that states them.
TEST(NotedHoles, StatedValuesAreNamedAsTheyAreWritten) {
  const sheet::DimensionsInView view{three_views()[0].name, three_views()[0].projection, {}};
  sheet::AnchoredDimension length{};
  length.type = DimensionType::linear;
  length.direction = DimensionDirection::horizontal;
  length.points = {{0, 0, 0}, {50, 0, 0}};
  for (const auto& [decimals, text] : {std::pair(0, "50"), std::pair(1, "50.0"), std::pair(3, "50.000")}) {
    length.stated = scene::StatedValue{50, decimals};
    EXPECT_EQ(sheet::text_of(length, view, {}), text);
  }
}

}  // namespace epura::test::noted_holes_test
