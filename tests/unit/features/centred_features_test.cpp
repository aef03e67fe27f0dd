// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: which centre lines a part has, and how long they are.
#include "features/centred_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cut/cut_world.hpp"
#include "known_parts.hpp"
#include "mesh/read.hpp"
#include "recognised.hpp"

namespace epura::test::centred_features_test {
namespace {

features::CentredFeatures features_of(const Part& part, const std::string& transform = "scale:1") {
  return features::find_centred_features(world_of(part, transform));
}

double largest_radius(const features::CentredRound& feature) {
  double radius = 0;
  for (const features::Ring& ring : feature.rings) radius = std::max(radius, ring.radius);
  return radius;
}

void expect_ends(const features::CentredRound& feature, Vec3 from, Vec3 to) {
  Vec3 first = feature.rings.front().centre, last = feature.rings.back().centre;
  if (glm::distance(first, from) > glm::distance(last, from)) std::swap(first, last);
  EXPECT_LT(glm::distance(first, from), 1e-6) << first.x << ' ' << first.y << ' ' << first.z;
  EXPECT_LT(glm::distance(last, to), 1e-6) << last.x << ' ' << last.y << ' ' << last.z;
}

// A block around a hollow ball, with equal bores into it from three sides.
std::string drilled_block(double half, double ball, double bore) {
  constexpr int steps = 8;
  Model model;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 normal = sign * Mat3(1)[axis], aside = Mat3(1)[(axis + 1) % 3], along = glm::cross(normal, aside);
      const auto at = [&](double height, const Loop& loop) {
        std::vector<Vec3> points;
        for (const Vec2& p : loop) points.push_back(height * normal + p.x * aside + p.y * along);
        return points;
      };
      const auto band = [&model](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
        for (std::size_t i = 0, j = 1; i < a.size(); ++i, j = (i + 1) % a.size()) model.face({a[i], a[j], b[j], b[i]});
      };
      const Loop rim = circle({0, 0}, bore, -135);
      const std::vector<Vec3> out = at(half, square(Vec2(-half), Vec2(2 * half))), mouth = at(half, rim);
      const std::vector<Vec3> end = at(std::sqrt(ball * ball - bore * bore), rim);
      band(out, mouth);
      if (sign > 0) band(mouth, end);
      for (std::size_t i = 0, j = 1; i < end.size() && sign < 0; ++i, j = (i + 1) % end.size()) {
        model.face({half * normal, mouth[i], mouth[j]});
        model.face({ball * normal, end[j], end[i]});
      }
      std::vector<Vec3> last = end;
      for (int step = 1; step <= steps; ++step) {
        std::vector<Vec3> next;
        for (std::size_t i = 0; i < end.size(); ++i)
          next.push_back(ball * glm::normalize(glm::mix(glm::normalize(end[i]), glm::normalize(out[i]),
                                                        static_cast<double>(step) / steps)));
        band(last, next);
        last = next;
      }
    }
  return model.obj();
}

// Each ends in the ball: its axis is none of the ball.
TEST(CentredFeatures, EqualBoresIntoABallEndInIt) {
  const auto mesh = std::make_shared<const mesh::Mesh>(mesh::read_mesh(drilled_block(30, 20, 5), "block.obj"));
  const features::CentredFeatures found =
      features::find_centred_features(laboratory::recognised(world::make_world({{mesh}})));
  ASSERT_EQ(found.round.size(), 3U);
  for (const features::CentredRound& bore : found.round) {
    const Vec3 along = glm::abs(bore.axis);
    expect_ends(bore, std::sqrt(375.0) * along, 30.0 * along);
  }
}

// A shaft with a fillet, a step, a chamfer and a round end.
const Part shaft = revolved(joined({{{0, 0}, {18, 0}, {20, 2}, {20, 30}},
                                    arc({15, 35}, 5, -90, -180, 6),
                                    {{10, 60}},
                                    arc({0, 60}, 10, 0, 90, 8)}),
                            36)
                       .move([](const Vec3& p) { return p.z > 69.999 ? Vec3(0, 0, p.z) : p; });

TEST(CentredFeatures, AShaftIsOneFromEndToEnd) {
  const features::CentredFeatures found = features_of(shaft, "scale:2 translate:5,0,0");
  ASSERT_EQ(found.round.size(), 1U);
  expect_ends(found.round[0], {5, 0, 0}, {5, 0, 140});
  EXPECT_NEAR(largest_radius(found.round[0]), 40, 1e-6);
  EXPECT_FALSE(found.round[0].enclosed);
  expect_ends(features_of(shaft, "scale:-1,1,1 rotate:y,90").round.at(0), {0, 0, 0}, {70, 0, 0});
}

TEST(CentredFeatures, ABoreIsEnclosed) {
  const features::CentredFeatures found = features_of(plate_with_hole(20, 5, 8, 8));
  ASSERT_EQ(found.round.size(), 1U);
  expect_ends(found.round[0], {0, 0, 0}, {0, 0, 5});
  EXPECT_NEAR(largest_radius(found.round[0]), 8, 1e-9);
  EXPECT_TRUE(found.round[0].enclosed);
  EXPECT_EQ(found.round[0].vertices.size(), 64U);
}

TEST(CentredFeatures, AHexagonHasAnAxisOrContinuesOne) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 6; ++i) outline.emplace_back(12 * std::cos(i * pi / 3), 12 * std::sin(i * pi / 3));
  const Part head = prism(outline, 8), shank = moved(revolved({{0, 0}, {6, 0}, {6, 30}, {0, 30}}, 36), {0, 0, -30});
  const features::CentredFeatures alone = features_of(head), bolt = features_of(together({head, shank}));
  ASSERT_EQ(alone.round.size(), 1U);
  expect_ends(alone.round[0], {0, 0, 0}, {0, 0, 8});
  EXPECT_NEAR(largest_radius(alone.round[0]), 12, 1e-9);
  EXPECT_FALSE(alone.round[0].enclosed);
  ASSERT_EQ(bolt.round.size(), 1U);
  expect_ends(bolt.round[0], {0, 0, -30}, {0, 0, 8});
  std::vector<Vec2> sides, bore;
  for (int i = 0; i < 24; ++i) {
    sides.push_back(glm::mix(outline[i / 4], outline[(i / 4 + 1) % 6], i % 4 / 4.0));
    bore.push_back(6.0 * Vec2(std::cos(i * pi / 12), std::sin(i * pi / 12)));
  }
  const features::CentredFeatures nut = features_of(plate_between(sides, bore, 10));
  ASSERT_EQ(nut.round.size(), 1U);
  EXPECT_FALSE(nut.round[0].enclosed) << "it is seen from the side";
  const features::CentredFeatures socket = features_of(with_opening(outline, 10));
  ASSERT_EQ(socket.round.size(), 1U);
  EXPECT_TRUE(socket.round[0].enclosed);
}

TEST(CentredFeatures, HolesInOneLineHaveOneAxis) {
  const features::CentredFeatures found =
      features_of(together({plate_with_hole(20, 5, 8, 8), moved(plate_with_hole(20, 5, 6, 8), {0, 0, 95})}));
  ASSERT_EQ(found.round.size(), 1U);
  expect_ends(found.round[0], {0, 0, 0}, {0, 0, 100});
  // Beside each other by a tenth of a millimetre they are two.
  EXPECT_EQ(features_of(together({plate_with_hole(20, 5, 8, 8), moved(plate_with_hole(20, 5, 6, 8), {0.1, 0, 95})}))
                .round.size(),
            2U);
}

std::vector<Vec2> rounded_rectangle(Vec2 half, double radius) {
  const Vec2 c = half - Vec2(radius);
  return joined({arc(c, radius, 0, 90, 6), arc({-c.x, c.y}, radius, 90, 180, 6), arc(-c, radius, 180, 270, 6),
                 arc({c.x, -c.y}, radius, 270, 360, 6)});
}

TEST(CentredFeatures, RoundedCornersHaveNone) {
  const Part plate = prism(rounded_rectangle({40, 20}, 8), 10);
  EXPECT_TRUE(features_of(plate).round.empty());
  // Nor have several one above the other: four quarters of a turn on the same side are no whole one.
  EXPECT_TRUE(
      features_of(together({plate, moved(plate, {0, 0, 20}), moved(plate, {0, 0, 40}), moved(plate, {0, 0, 60})}))
          .round.empty());
}

TEST(CentredFeatures, ABoreWithTwoFlatsHasAnAxis) {
  const double half = std::acos(0.6) * 180 / pi;  // 53.13 degrees on either side of y
  const auto outline = joined({arc({0, 0}, 10, 90 - half, 90 + half, 12), arc({0, 0}, 10, 270 - half, 270 + half, 12)});
  const features::CentredFeatures found = features_of(with_opening(outline, 10));
  ASSERT_EQ(found.round.size(), 1U);
  expect_ends(found.round[0], {0, 0, 0}, {0, 0, 10});
  EXPECT_FALSE(found.round[0].enclosed);
}

TEST(CentredFeatures, ASlotIsOne) {
  for (const bool is_opening : {true, false}) {
    const Part part = is_opening ? with_opening(obround(20, 6), 10) : prism(obround(20, 6), 10);
    const features::CentredFeatures found = features_of(part, "rotate:z,30");
    EXPECT_TRUE(found.round.empty());
    ASSERT_EQ(found.slots.size(), 1U);
    const auto& ends = found.slots[0].ends;
    const Vec3 middle = 0.5 * (ends[0].rings[0].centre + ends[1].rings[0].centre);
    const Vec3 apart = ends[0].rings[0].centre - ends[1].rings[0].centre;
    EXPECT_LT(glm::length(Vec2(middle)), 1e-6);
    EXPECT_NEAR(glm::length(apart), 40, 1e-6);
    EXPECT_NEAR(std::abs(apart.y), 20, 1e-6);
    EXPECT_NEAR(ends[0].rings[0].radius, 6, 1e-6);
    EXPECT_EQ(ends[0].enclosed && ends[1].enclosed, is_opening);
  }
}

TEST(CentredFeatures, SlotsInARowDoNotJoin) {
  const features::CentredFeatures found =
      features_of(together({prism(obround(20, 6), 10), moved(prism(obround(20, 6), 10), {60, 0, 0})}));
  ASSERT_EQ(found.slots.size(), 2U);
  for (const features::CentredSlot& slot : found.slots)
    EXPECT_NEAR(glm::distance(slot.ends[0].rings[0].centre, slot.ends[1].rings[0].centre), 40, 1e-6);
}

std::vector<Vec2> bent_bar(double inner, double outer, Vec2 aside = {0, 0}) {
  std::vector<Vec2> outline = arc({0, 0}, outer, 0, 220, 40), back = arc(aside, inner, 220, 0, 40);
  outline.insert(outline.end(), back.begin(), back.end());
  return outline;
}

TEST(CentredFeatures, GroovesInAnArcHaveNone) {
  // As an opening it is a groove or the stroke of a letter, as a body a hook.
  EXPECT_TRUE(features_of(with_opening(bent_bar(18, 20), 3)).round.empty());
  EXPECT_EQ(features_of(prism(bent_bar(18, 20), 3)).round.size(), 1U);
  // A stroke need not be as wide everywhere.
  EXPECT_TRUE(features_of(with_opening(bent_bar(18, 20, {0.5, 0.5}), 3)).round.empty());
}

// Holes of radius 4 around one of radius 9.
Part flange(const std::vector<Vec2>& places, double middle = 9) {
  std::vector<Bore> bores{{{0, 0}, middle}};
  for (const Vec2& at : places) bores.push_back({at, 4});
  return plate_with_bores(bores);
}

TEST(CentredFeatures, HolesAroundABoreLieOnAPitchCircle) {
  for (const auto& places : {std::vector<Vec2>{{30, 0}, {0, 30}, {-30, 0}, {0, -30}}, {{30, 0}, {0, 30}, {-30, 0}}}) {
    const features::CentredFeatures found = features_of(flange(places), "translate:7,0,0");
    EXPECT_EQ(found.round.size(), places.size() + 1);
    ASSERT_EQ(found.pitch_circles.size(), 1U);
    EXPECT_NEAR(found.pitch_circles[0].radius, 30, 1e-6);
    EXPECT_LT(glm::length(Vec2(found.pitch_circles[0].centre) - Vec2(7, 0)), 1e-6);
    EXPECT_EQ(found.pitch_circles[0].holes.size(), places.size());
    for (const int hole : found.pitch_circles[0].holes)
      EXPECT_NEAR(largest_radius(found.round[std::size_t(hole)]), 4, 1e-6);
  }
}

TEST(CentredFeatures, OtherHolesLieOnNone) {
  EXPECT_TRUE(features_of(flange({{30, 0}, {-30, 0}})).pitch_circles.empty());
  // Corners of a rectangle; a row; holes around one like themselves.
  EXPECT_TRUE(features_of(flange({{30, 60}, {-30, 60}, {-30, -60}, {30, -60}})).pitch_circles.empty());
  // Nor do three of them, nor three of a square if the fourth hole is elsewhere: any three holes lie on a circle.
  EXPECT_TRUE(features_of(flange({{30, 60}, {-30, 60}, {-30, -60}})).pitch_circles.empty());
  EXPECT_TRUE(features_of(flange({{30, 30}, {-30, 30}, {-30, -30}, {30, 0}})).pitch_circles.empty());
  EXPECT_TRUE(features_of(flange({{-30, 60}, {0, 60}, {30, 60}, {60, 30}})).pitch_circles.empty());
  EXPECT_TRUE(features_of(flange({{30, 0}, {60, 0}, {90, 0}})).pitch_circles.empty());
  EXPECT_TRUE(features_of(flange({{30, 0}, {0, 30}, {-30, 0}, {0, -30}}, 4)).pitch_circles.empty());
  // One is larger.
  const std::vector<Bore> bores{{{0, 0}, 9}, {{30, 0}, 4}, {{0, 30}, 4}, {{-30, 0}, 5}};
  EXPECT_TRUE(features_of(plate_with_bores(bores)).pitch_circles.empty());
  // Those of a square do.
  EXPECT_EQ(features_of(flange({{30, 30}, {-30, 30}, {-30, -30}, {30, -30}})).pitch_circles.size(), 1U);
}

features::CentredFeatures cut(double x) {
  const scene::CuttingPlane plane =
      scene::make_cutting_plane(scene::parse_section(std::to_string(x) + ",0,0:1,0,0", "section"));
  const world::World world = world_of(plate_with_hole(20, 5, 8, 8));
  return features::find_centred_features(cut::cut_world(world, plane).world);
}

TEST(CentredFeatures, ACutLeavesAxesThatItDoesNotTakeAway) {
  for (const double x : {0.0, 3.0}) {
    ASSERT_EQ(cut(x).round.size(), 1U) << x;
    expect_ends(cut(x).round[0], {0, 0, 0}, {0, 0, 5});
    EXPECT_FALSE(cut(x).round[0].enclosed);
  }
  EXPECT_TRUE(cut(-3).round.empty());
  EXPECT_TRUE(cut(12).round.at(0).enclosed);
}

TEST(CentredFeatures, WhereNoFacesAreRecognisedRimsCount) {
  const auto mesh = std::make_shared<const mesh::Mesh>(plate_with_hole(20, 5, 8, 8).mesh());
  EXPECT_EQ(features::find_centred_features(world::make_world({{mesh, Mat4(1)}})).round.size(), 2U);
  // Circles that a stretched model has left.
  EXPECT_EQ(features_of(plate_with_hole(20, 5, 8, 8), "scale:1,1,3").round.size(), 2U);
  EXPECT_TRUE(features_of(plate_with_hole(20, 5, 8, 8), "scale:1,2,1").round.empty());
}

// Two bosses with an arm between them, one of whose sides is moved.
TEST(CentredFeatures, AnArmHasTheLineOfCentresInItsMiddle) {
  for (const double moved : {0.0, 1.0}) {
    Loop outline;
    const auto add_arc = [&](const Vec2& centre, double radius, double from, double to) {
      for (int i = 0; i <= 72; ++i)
        outline.push_back(centre +
                          radius * Vec2(cosine(from + (to - from) * i / 72), sine(from + (to - from) * i / 72)));
    };
    const auto angle = [](double half, double radius) { return std::asin(half / radius) * 180 / std::numbers::pi; };
    add_arc({0, 0}, 15, angle(5, 15), 360 - angle(5 - moved, 15));
    add_arc({60, 0}, 10, angle(5 - moved, 10) - 180, 180 - angle(5, 10));
    const auto mesh = std::make_shared<const mesh::Mesh>(mesh::read_mesh(block(outline, 8), "arm.obj"));
    const features::CentredFeatures found =
        features::find_centred_features(laboratory::recognised(world::make_world({{mesh}})));
    ASSERT_EQ(found.round.size(), 2U);
    ASSERT_EQ(found.arms.size(), moved > 0 ? 0U : 1U);
    if (moved == 0) {
      EXPECT_NEAR(found.arms[0].width, 10, 1e-6);
    }
  }
}

// Of a plate that is turned as a whole; its bore stays along the axis about which it is turned.
TEST(CentredFeatures, OfATurnedPartAreAlongItsOwnAxes) {
  EXPECT_EQ(features_of(plate_with_bores({{{10, 5}, 4}})).round.at(0).beside, Vec3(0));
  const Vec3 along(cosine(27), sine(27), 0);
  for (const char* const steps : {"rotate:z,27", "rotate:z,27 translate:3,5,7"}) {
    const Vec3 beside = features_of(plate_with_bores({{{10, 5}, 4}}), steps).round.at(0).beside;
    EXPECT_NEAR(glm::length(beside), 1, 1e-9) << steps;
    EXPECT_NEAR(std::max(std::abs(glm::dot(beside, along)), std::abs(glm::dot(beside, {-along.y, along.x, 0}))), 1,
                1e-6)
        << steps;
  }
}

}  // namespace
}  // namespace epura::test::centred_features_test
