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

// A plate of 60 x 40 with a hole about (25, 18), from its top down; one that is not through ends in a point.
std::string plate_with(const std::vector<Ring>& rings, bool is_through) {
  const Vec2 centre(25, 18);
  const Loop border = square({0, 0}, {60, 40});
  std::vector<Loop> holes;
  for (const Ring& ring : rings) holes.push_back(circle(centre, ring.radius, -135));
  const auto at = [&](std::size_t ring, std::size_t p) {
    return ring == rings.size() ? Vec3(centre, 3) : Vec3(holes[ring][p], rings[ring].z);
  };
  Model model;
  std::vector<Vec3> bottom;
  for (std::size_t p = 0; p < border.size(); ++p) {
    const std::size_t q = (p + 1) % border.size(), last = rings.size() - 1;
    model.face({Vec3(border[p], thickness), Vec3(border[q], thickness), at(0, q), at(0, p)});
    for (std::size_t ring = 0; ring + 1 < rings.size() + (is_through ? 0 : 1); ++ring)
      model.face({at(ring, p), at(ring, q), at(ring + 1, q), at(ring + 1, p)});
    model.face({Vec3(border[q], thickness), Vec3(border[p], thickness), Vec3(border[p], 0), Vec3(border[q], 0)});
    if (is_through) model.face({at(last, p), at(last, q), Vec3(border[q], 0), Vec3(border[p], 0)});
    bottom.insert(bottom.begin(), Vec3(border[p], 0));
  }
  if (!is_through) model.face(bottom);
  return model.obj();
}

// Of lint and of define, one word for each fault.
std::string faults_of(const DimensionedPart& part) {
  const sheet::FreeFaces free = part.free();
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

}  // namespace

// The plate is as thick as the countersink is wide: only the sign tells which is meant.
TEST(NotedHoles, OfCountersinksAreHeldByDiameterAndAngle) {
  const DimensionedPart part(plate_with({{5, 10}, {2.5, 7.5}, {2.5, 0}}, true));
  ASSERT_TRUE(has(part.texts, "<> ⌵⌀10×90°")) << testing::PrintToString(part.texts);
  EXPECT_EQ(faults_of(part), "");
}

TEST(NotedHoles, OfDrillPointsAreHeldByTheirDepth) {
  const double point = 3 / std::tan(59 / 180.0 * std::numbers::pi);
  const DimensionedPart part(plate_with({{3, 10}, {3, 3 + point}}, false));
  EXPECT_EQ(faults_of(part), "");
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
