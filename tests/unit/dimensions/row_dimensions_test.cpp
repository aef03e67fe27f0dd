// SPDX-License-Identifier: Apache-2.0
// Lengths that are arranged together, and lengths of arcs: what they say, and that nothing of them crosses a text.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/text.hpp"
#include "dimensions_support.hpp"
#include "errors.hpp"

namespace epura::test::row_dimensions_test {
namespace {

/// A box of 100 x 20 x 30 from the origin, in front view.
world::World beam() { return placed(box({0, 0, 0}, {100, 20, 30})); }

scene::DimensionDescription row(DimensionArrangement arrangement, const std::vector<double>& places) {
  scene::DimensionDescription description = dimension("linear", {}, "horizontal");
  description.arrangement = {arrangement, "scene.toml:9:1"};
  for (const double x : places) description.anchors.emplace_back(Vec3(x, 0, 0));
  return description;
}

std::vector<std::string> texts_of(const scene::DimensionDescription& description) {
  const world::World world = beam();
  std::vector<std::string> texts;
  for (const sheet::Text& text : layer_of(world, drawing_of(world, orthographic(from_front)), {description}).texts)
    texts.push_back(text.text);
  std::sort(texts.begin(), texts.end());
  return texts;
}

using Texts = std::vector<std::string>;

TEST(RowDimensions, ChainsMeasureFromPlaceToPlace) {
  EXPECT_EQ(texts_of(row(DimensionArrangement::chain, {0, 60, 20, 90})), (Texts{"20", "30", "40"}));
}

TEST(RowDimensions, ParallelOnesMeasureFromTheFirstPlace) {
  EXPECT_EQ(texts_of(row(DimensionArrangement::baseline, {20, 0, 60, 90})), (Texts{"20", "40", "70"}));
}

TEST(RowDimensions, CommonOriginsHaveNegativeLengthsToTheLeft) {
  EXPECT_EQ(texts_of(row(DimensionArrangement::ordinate, {20, 0, 60, 90})), (Texts{"-20", "0", "40", "70"}));
}

TEST(RowDimensions, HaveTolerances) {
  scene::DimensionDescription chain = row(DimensionArrangement::chain, {0, 20, 60});
  chain.tolerance = {"±0.1", "scene.toml:10:1"};
  EXPECT_EQ(texts_of(chain), (Texts{"20 ±0.1", "40 ±0.1"}));
}

// The arrows of parallel dimension lines are one step of 8 mm apart, short lines inside.
TEST(RowDimensions, ParallelLinesAreInSteps) {
  const world::World world = beam();
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const sheet::Layer layer = layer_of(world, front, {row(DimensionArrangement::baseline, {0, 90, 30, 60})});
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = tips(layer, i);
    EXPECT_NEAR(std::abs(high.x - low.x), 30 * (double(i) + 1), 1e-9);
    EXPECT_NEAR(low.y, front.box.min.y - 10 - 8 * double(i), 1e-9);
    EXPECT_NEAR(high.y, low.y, 1e-9);
  }
}

// Boxes of texts against each other, against lines, and against arrows, for places as near as 1 mm.
void expect_clear(const sheet::Layer& layer, const std::string& what) {
  const sheet::Lettering lettering;
  std::vector<sheet::TurnedBox> texts;
  for (const sheet::Text& text : layer.texts) texts.push_back(sheet::box_of(text, lettering));
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = i + 1; j < texts.size(); ++j)
      EXPECT_FALSE(sheet::overlap(texts[i], texts[j]))
          << what << ": " << layer.texts[i].text << " on " << layer.texts[j].text;
    for (const sheet::Stroke& stroke : layer.strokes)
      for (std::size_t k = 1; k < stroke.points.size(); ++k)
        EXPECT_FALSE(sheet::overlap(texts[i], sheet::line_box(stroke.points[k - 1], stroke.points[k])))
            << what << ": a line through " << layer.texts[i].text;
    for (const sheet::Fill& fill : layer.fills)
      for (std::size_t k = 0; k < fill.rings[0].size(); ++k)
        EXPECT_FALSE(
            sheet::overlap(texts[i], sheet::line_box(fill.rings[0][k], fill.rings[0][(k + 1) % fill.rings[0].size()])))
            << what << ": an arrow in " << layer.texts[i].text;
  }
}

TEST(RowDimensions, AreClearOfTheirTexts) {
  const world::World world = beam();
  const std::vector<std::vector<double>> places{
      {0, 20, 60, 90},          {0, 1, 2, 60, 62, 63}, {0, 3, 5, 9, 10, 14, 99},
      {50, 49, 51, 48, 0, 100}, {100, 97, 94, 30, 2},  {0, 7, 14, 21, 28, 35, 42, 49, 56, 63, 70, 77, 84, 91}};
  for (const double scale : {0.5, 1.0, 3.0})
    for (const auto& some : places)
      for (const auto arrangement :
           {DimensionArrangement::baseline, DimensionArrangement::chain, DimensionArrangement::ordinate})
        for (const double offset : {-12.0, 12.0}) {
          const bool is_between = some.front() == 50;
          // Short lengths to both sides of the origin have no place for their texts.
          if (is_between && arrangement == DimensionArrangement::baseline) continue;
          scene::DimensionDescription description = row(arrangement, some);
          description.offset = {offset, ""};
          const std::string what(scene::word_of(arrangement));
          expect_clear(layer_of(world, drawing_of(world, orthographic(from_front), scale), {description}),
                       what + " of " + std::to_string(some.size()) + " at " + std::to_string(scale));
        }
}

TEST(RowDimensions, WithTwoPlacesOnOneLineAreRefused) {
  const world::World world = beam();
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const Error error = error_of([&] { layer_of(world, front, {row(DimensionArrangement::chain, {0, 20, 20, 60})}); });
  EXPECT_STREQ(error.what(), "scene.toml:7: two of its places have the same extension line");
}

/// A sector of a cylinder of radius 50 around the z axis.
Shape sector(double degrees) {
  constexpr int steps = 40;
  Shape shape;
  std::vector<int> bottom, top;
  const auto add = [&](double x, double y) {
    for (const double z : {0.0, 5.0}) {
      (z > 0 ? top : bottom).push_back(static_cast<int>(shape.points.size()));
      shape.points.push_back({x, y, z});
    }
  };
  add(0, 0);
  for (int i = 0; i <= steps; ++i) {
    const double angle = degrees * i / steps * std::numbers::pi / 180;
    add(50 * std::cos(angle), 50 * std::sin(angle));
  }
  for (std::size_t i = 0; i < top.size(); ++i) {
    const std::size_t j = (i + 1) % top.size();
    shape.faces.push_back({bottom[i], bottom[j], top[j], top[i]});
  }
  shape.faces.push_back(top);
  shape.faces.push_back({bottom.rbegin(), bottom.rend()});
  return shape;
}

TEST(ArcDimensions, StateTheLengthOfTheArc) {
  for (const double degrees : {75.0, 90.0, 150.0, 270.0}) {
    const world::World world = placed(sector(degrees));
    const drawing::ViewDrawing top = drawing_of(world, from_above());
    const sheet::Layer layer = layer_of(world, top, {dimension("arc", {3})});
    const double length = 50 * degrees * std::numbers::pi / 180;
    EXPECT_EQ(layer.texts.at(0).text, "⌒" + format_fixed(length, 2)) << degrees;
    // Up to a right angle, the dimension line is as long as the arc; beyond, it is around the same centre.
    const auto [a, b] = tips(layer);
    const double chord = 2 * std::sin(degrees / 2 * std::numbers::pi / 180);
    const double radius = glm::length(a - b) / chord;
    if (degrees <= 90) {
      EXPECT_NEAR(radius, 50, 1e-6);
    } else {
      EXPECT_GE(radius, 60 - 1e-6);
    }
  }
}

TEST(ArcDimensions, OfWholeCirclesAreRefused) {
  const world::World world = placed(cylinder(64, 10, 7));
  const drawing::ViewDrawing top = drawing_of(world, from_above());
  EXPECT_TRUE(contains(error_of([&] { layer_of(world, top, {dimension("arc", {3})}); }).what(),
                       "the view shows no arc at this place in its true form"));
}

// Sixteen places in one row would be a fan: half of them stand above, each with the origin.
TEST(RowDimensions, FansStandOnTwoSides) {
  const world::World world = beam();
  std::vector<double> places{0};
  for (int i = 1; i <= 16; ++i) places.push_back(6 * i);
  const std::vector<scene::DimensionDescription> fan{row(DimensionArrangement::ordinate, places)};
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), 2);
  const sheet::PlacedLayer placed = sheet::place_dimensions({world, front, fan, 1}, {sheet::Lettering(), 0.25});
  EXPECT_TRUE(placed.left_out.empty());
  EXPECT_EQ(placed.count, 1U);
  std::size_t above = 0, below = 0, origins = 0;
  for (const sheet::Text& text : placed.layer.texts) {
    if (text.text == "0") ++origins;
    ++(text.at.y > front.box.max.y ? above : below);
  }
  EXPECT_EQ(above, 9U);
  EXPECT_EQ(below, 9U);
  EXPECT_EQ(origins, 2U);
  EXPECT_TRUE(placed.fans.empty());
  // Twelve are none.
  places.resize(13);
  const std::vector<scene::DimensionDescription> few{row(DimensionArrangement::ordinate, places)};
  EXPECT_EQ(sheet::place_dimensions({world, front, few, 1}, {sheet::Lettering(), 0.25}).layer.texts.size(), 13U);
}

TEST(RowDimensions, FansAreTold) {
  const world::World world = beam();
  const auto fans = [&world](int count, double scale) {
    std::vector<double> places{0};
    for (int i = 1; i <= count; ++i) places.push_back(3 * i);
    const std::vector<scene::DimensionDescription> one{row(DimensionArrangement::ordinate, places)};
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), scale);
    return sheet::place_dimensions({world, front, one, 1}, {sheet::Lettering(), 0.25}).fans.size();
  };
  EXPECT_EQ(fans(24, 2), 0U) << "twelve on each side";
  EXPECT_EQ(fans(26, 2), 2U) << "thirteen";
  EXPECT_EQ(fans(16, 0.5), 0U) << "nine texts, 5.25 mm each, beside a view of 50 mm";
  EXPECT_EQ(fans(20, 0.5), 2U) << "eleven";
}

// On either side of a view, its extension line is where the row has the text of its origin.
TEST(RowDimensions, LeaveRoomForAnOverallSize) {
  const world::World world = beam();
  scene::DimensionDescription overall = dimension("linear", {}, "horizontal");
  overall.anchors = {Vec3(0, 0, 0), Vec3(100, 0, 0)};
  for (const double scale : {1.0, 1.5, 2.0})
    for (const double pitch : {3.1, 4.0, 5.5}) {
      std::vector<double> places{0};
      for (double at = pitch; at < 98; at += pitch) places.push_back(at);
      const std::vector<scene::DimensionDescription> both{row(DimensionArrangement::ordinate, places), overall};
      const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), scale);
      const sheet::PlacedLayer placed = sheet::place_dimensions({world, front, both, 2}, {sheet::Lettering(), 0.25});
      EXPECT_TRUE(placed.left_out.empty()) << scale << " " << pitch;
      EXPECT_FALSE(placed.has_conflicts) << scale << " " << pitch;
    }
}

}  // namespace
}  // namespace epura::test::row_dimensions_test
