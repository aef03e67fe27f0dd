// SPDX-License-Identifier: Apache-2.0
// Parts for which everyone can count the numbers that define them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "definition/rank.hpp"
#include "made_parts.hpp"

namespace epura::definition::closed_forms_test {

namespace {

const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

Part with(Part part, const std::vector<Face>& more) {
  part.faces.insert(part.faces.end(), more.begin(), more.end());
  return part;
}

Part shaft() {
  Part part{{cylinder({0, 0, 10}, z, 10, 1000), cylinder({0, 0, 30}, z, 8, 900), cylinder({0, 0, 55}, z, 5, 800),
             plane({0, 0, 0}, -z, 300), plane({9, 0, 20}, z, 100), plane({7, 0, 40}, z, 90), plane({0, 0, 70}, z, 80)}};
  part.size = 75;
  return part;
}

// Of a block, a slot along x through its top: its ends, then its sides.
Part slotted() {
  Part part = with(box({60, 40, 10}), {cylinder({20, 15, 5}, z, 4, 120), cylinder({45, 15, 5}, z, 4, 120),
                                       plane({32, 11, 5}, y, 250), plane({32, 19, 5}, -y, 250)});
  for (const int end : {6, 7})
    for (const int side : {8, 9}) {
      const double at = end == 6 ? 20 : 45, wall = side == 8 ? 11 : 19;
      part.contacts.push_back({{end, side}, {{at, wall, 0}, {at, wall, 10}}, true});
    }
  return part;
}

// A notch across the top of a block; its sides are inclined by 60 and 30 degrees, or both by 45.
Part notched(double left_angle, double right_angle) {
  const auto side = [](double sign, double angle) {
    return plane({30 + sign * 3, 20, 8}, {-sign * std::sin(angle), 0, std::cos(angle)}, 300);
  };
  return with(box({60, 40, 10}), {side(-1, left_angle), side(1, right_angle)});
}

void expect_moves_with_part(const MadeSheet& sheet) {
  std::vector<Statement> all = sheet.rules;
  all.insert(all.end(), sheet.dimensions.begin(), sheet.dimensions.end());
  for (const Statement& statement : all)
    for (const Row& row : statement.rows)
      for (std::size_t motion = 0; motion < 6; ++motion) {
        double sum = 0;
        for (const Term& term : row) sum += term.factor * sheet.unknowns.rigid(term.unknown)[motion];
        EXPECT_NEAR(sum, 0, 1e-9) << statement.name << ", motion " << motion;
      }
}

}  // namespace

TEST(Definition, A_box_has_three_sizes) {
  MadeSheet sheet(box({60, 40, 10}));
  EXPECT_EQ(sheet.needed(), 3);
  EXPECT_EQ(sheet.account().motions.size(), 3U);
  EXPECT_FALSE(sheet.account().is_complete());
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  EXPECT_TRUE(sheet.account().is_complete());
  EXPECT_TRUE(sheet.account().repeated.empty());
  expect_moves_with_part(sheet);
}

TEST(Definition, Without_rules_each_plane_of_a_box_has_three_unknowns) {
  const MadeSheet sheet(box({60, 40, 10}), {}, rules_of(Standard::none));
  EXPECT_EQ(sheet.needed(), 6 * 3 - 6);
  EXPECT_TRUE(sheet.rules.empty());
}

TEST(Definition, A_bore_adds_a_diameter_and_two_places) {
  MadeSheet sheet(with(box({60, 40, 10}), {cylinder({20, 15, 5}, z, 4, 250)}));
  EXPECT_EQ(sheet.needed(), 6);
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  sheet.distance(left, 6, left).distance(front, 6, front);
  ASSERT_EQ(sheet.account().motions.size(), 1U);
  EXPECT_EQ(sheet.account().motions[0].faces, std::vector<int>{6});
  EXPECT_EQ(sheet.account().states[6], FaceState::free);
  EXPECT_EQ(sheet.account().states[top], FaceState::fixed);
  EXPECT_EQ(sheet.sentences(),
            std::vector<std::string>{
                "cylinder R4 face of 250 mm² at (20, 15, 5): its radius is free; add a radius or diameter"});
  sheet.size(6);
  EXPECT_TRUE(sheet.account().is_complete());
  expect_moves_with_part(sheet);
}

TEST(Definition, The_floor_of_a_blind_bore_adds_a_depth) {
  MadeSheet sheet(with(box({60, 40, 10}), {cylinder({20, 15, 7}, z, 4, 150), plane({20, 15, 4}, z, 50)}));
  EXPECT_EQ(sheet.needed(), 7);
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  sheet.distance(left, 6, left).distance(front, 6, front).size(6);
  EXPECT_EQ(sheet.sentences(),
            std::vector<std::string>{"plane face of 50 mm² at (20, 15, 4): can move along z; add a distance along z"});
}

// What is drilled ends at 118 degrees, drawn as 120; any other angle is a size.
TEST(Definition, The_point_of_a_blind_bore_has_a_size_if_it_is_not_that_of_a_drill) {
  for (const double angle : {60.0, 90.0, 117.0, 118.0, 120.0, 121.0, 140.0}) {
    const double slope = std::tan(angle / 360 * std::numbers::pi);
    Part part = with(box({60, 40, 20}), {cylinder({20, 15, 14}, z, 4, 300), cone({20, 15, 7}, z, 2, slope, 60)});
    for (const auto& faces : {std::array{6, int{top}}, std::array{6, 7}})
      part.contacts.push_back({faces, {{24, 15, faces[1] == 7 ? 8 : 20}, {16, 15, faces[1] == 7 ? 8 : 20}}});
    EXPECT_EQ(MadeSheet(part).needed(), 3 + 3 + 1 + (angle >= 118 && angle <= 120 ? 0 : 1)) << angle;
  }
}

TEST(Definition, A_pocket_that_nothing_places_slides_as_a_whole) {
  MadeSheet sheet(
      with(box({60, 40, 10}), {plane({10, 15, 7}, x, 60), plane({30, 15, 7}, -x, 60), plane({20, 10, 7}, y, 120),
                               plane({20, 20, 7}, -y, 120), plane({20, 15, 4}, z, 200)}));
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom).distance(top, 10, top);
  sheet.distance(6, 7, 6).distance(8, 9, 8).distance(front, 8, front);
  EXPECT_EQ(sheet.sentences(), std::vector<std::string>{"plane face of 60 mm² at (10, 15, 7) and 1 more face: can move "
                                                        "along x; add a distance along x"});
}

TEST(Definition, A_shaft_has_diameters_and_lengths) {
  MadeSheet sheet(shaft());
  EXPECT_EQ(sheet.needed(), 6);
  sheet.size(0).size(1).size(2).distance(3, 4, 3).distance(4, 5, 3);
  EXPECT_EQ(sheet.account().motions.size(), 1U);
  EXPECT_EQ(sheet.account().states[6], FaceState::free);
  sheet.distance(3, 6, 3);
  EXPECT_TRUE(sheet.account().is_complete());
  expect_moves_with_part(sheet);
}

// Two places more for each axis that is not shown to be that of the others.
TEST(Definition, A_shaft_without_a_centre_line_is_in_no_line) {
  Marks marks;
  marks.has_centre_lines = false;
  EXPECT_EQ(MadeSheet(shaft(), marks).needed(), 6 + 2 * 2);
  EXPECT_EQ(MadeSheet(box({60, 40, 10}), marks).needed(), 3);
}

TEST(Definition, A_pitch_circle_gives_places_of_all_its_holes) {
  Part plate = with(box({100, 80, 10}), {cylinder({50, 40, 5}, z, 20, 0)});
  PitchCircle circle{6, {}};
  for (const double angle : {10, 130, 250}) {
    const double at = angle * M_PI / 180;
    circle.axes.push_back(static_cast<int>(plate.faces.size()));
    plate.faces.push_back(cylinder({50 + 20 * std::cos(at), 40 + 20 * std::sin(at), 5}, z, 3, 180));
  }
  const Marks marks{.circles = {circle}};
  MadeSheet sheet(plate, marks);
  // Of the circle: diameter, two places, the direction of the first hole; of the holes: diameters.
  EXPECT_EQ(sheet.needed(), 3 + 4 + 3);
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  sheet.distance(left, 6, left).distance(front, 6, front).size(6).size(7).size(8).size(9);
  ASSERT_EQ(sheet.account().motions.size(), 1U);
  EXPECT_EQ(sheet.account().motions[0].faces, circle.axes);
  expect_moves_with_part(sheet);
  EXPECT_EQ(MadeSheet(plate).needed(), 3 + 3 + 3 * 3) << "without the circle";
}

// One with a hole on a centre line, and one whose holes are on both sides of it.
TEST(Definition, Pitch_circles_turn_as_their_centre_lines) {
  const auto needed = [](double first) {
    Part plate = with(box({100, 80, 10}), {cylinder({50, 40, 5}, z, 20, 0), cylinder({50, 40, 5}, z, 30, 0)});
    std::vector<PitchCircle> circles{{6, {}}, {7, {}}};
    const auto add = [&](PitchCircle& circle, double radius, int count, double from) {
      for (int i = 0; i < count; ++i) {
        const double at = (from + 360.0 * i / count) * M_PI / 180;
        circle.axes.push_back(static_cast<int>(plate.faces.size()));
        plate.faces.push_back(cylinder({50 + radius * std::cos(at), 40 + radius * std::sin(at), 5}, z, 3, 180));
      }
    };
    add(circles[0], 20, 3, 90);
    add(circles[1], 30, 8, first);
    return MadeSheet(plate, {.circles = circles}).needed();
  };
  // Of the box 3, of the circles two diameters and two places, of the holes their diameters.
  EXPECT_EQ(needed(22.5), 3 + 2 + 2 + 11);
  EXPECT_EQ(needed(0), 3 + 2 + 2 + 11);
  EXPECT_EQ(needed(10), 3 + 2 + 2 + 11 + 1) << "and the direction of the second circle";
}

TEST(Definition, Axes_that_are_even_about_another_turn_as_one) {
  Part plate = with(box({100, 80, 10}), {cylinder({50, 40, 5}, z, 5, 300)});
  EvenAxes even{6, {}};
  for (const double angle : {10, 82, 154, 226, 298}) {
    const double at = angle * M_PI / 180;
    even.axes.push_back(static_cast<int>(plate.faces.size()));
    plate.faces.push_back(cylinder({50, 40, 5}, {std::cos(at), std::sin(at), 1}, 3, 100));
  }
  EXPECT_EQ(MadeSheet(plate, {.even_axes = {even}}).needed(), MadeSheet(plate).needed() - 4);
}

TEST(Definition, A_wedge_has_two_sizes_and_an_angle) {
  Part wedge{{plane({0, 10, 5}, -x, 200), plane({15, 10, 0}, -z, 600), plane({15, 0, 4}, -y, 150),
              plane({15, 20, 4}, y, 150), plane({15, 10, 5}, {1, 0, 3}, 632)}};
  wedge.size = 38;
  MadeSheet sheet(wedge);
  EXPECT_EQ(sheet.needed(), 3);
  sheet.distance(2, 3, 2).angle(1, 4, y);
  EXPECT_EQ(sheet.account().motions.size(), 1U);
  // The height at the back: the slope is held where it meets it.
  sheet.dimensions.push_back(
      {"height", {length(sheet.unknowns, sheet.part, {End{{0, 10, 0}, {1}}, End{{0, 10, 10}, {4, 0}}}, z, 1)}});
  EXPECT_TRUE(sheet.account().is_complete());
  expect_moves_with_part(sheet);
}

TEST(Definition, A_slope_without_an_angle_turns) {
  MadeSheet sheet(with(box({60, 40, 10}), {plane({55, 20, 8}, {1, 0, 1.5}, 300)}));
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  sheet.dimensions.push_back(
      {"end", {length(sheet.unknowns, sheet.part, {End{{0, 20, 10}, {left}}, End{{52, 20, 10}, {top, 6}}}, x, left)}});
  const std::vector<std::string> said = sheet.sentences();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("can turn about y; add an angle"), std::string::npos) << said[0];
}

TEST(Definition, A_V_notch_has_two_angles_and_two_places) {
  const double wide = M_PI / 3, steep = M_PI / 6, half = M_PI / 4;
  EXPECT_EQ(MadeSheet(notched(wide, steep)).needed(), 3 + 4 - 1) << "at right angles to each other";
  EXPECT_EQ(MadeSheet(notched(wide, 0.7)).needed(), 3 + 4);
  Part both = with(notched(0.6, 0.6), {plane({30, 20, 5}, x, 0)});
  EXPECT_EQ(MadeSheet(both).needed(), 3 + 4 + 1) << "a plane that is drawn for nothing";
  EXPECT_EQ(MadeSheet(both, {.symmetries = {{8, {{left, right}, {6, 7}}}}}).needed(), 3 + 2);
  expect_moves_with_part(MadeSheet(both, {.symmetries = {{8, {{left, right}, {6, 7}}}}}));
  EXPECT_EQ(MadeSheet(notched(half, half)).needed(), 3 + 3);
}

TEST(Definition, A_dovetail_has_a_depth_too) {
  Part part = with(box({60, 40, 20}), {plane({30, 20, 12}, z, 500), plane({22, 20, 16}, {1, 0, -0.6}, 200),
                                       plane({38, 20, 16}, {-1, 0, -0.6}, 200), plane({30, 20, 5}, x, 0)});
  EXPECT_EQ(MadeSheet(part).needed(), 3 + 1 + 4 + 1);
  EXPECT_EQ(MadeSheet(part, {.symmetries = {{9, {{left, right}, {7, 8}}}}}).needed(), 3 + 1 + 2);
}

TEST(Definition, A_line_of_symmetry_places_holes_beside_and_on_it) {
  Part part = with(box({60, 40, 10}), {cylinder({15, 12, 5}, z, 3, 180), cylinder({45, 12, 5}, z, 3, 180),
                                       cylinder({30, 25, 5}, z, 5, 300), plane({30, 20, 5}, x, 0)});
  EXPECT_EQ(MadeSheet(part).needed(), 3 + 5 + 3) << "both holes in line; the plane with the axis in it";
  const Marks marks{.symmetries = {{9, {{left, right}, {6, 7}}, {8}}}};
  // Distance, place and diameter of both; place and diameter of the third.
  EXPECT_EQ(MadeSheet(part, marks).needed(), 3 + 3 + 2);
  expect_moves_with_part(MadeSheet(part, marks));
}

TEST(Definition, A_sphere_on_a_cone_adds_one_size) {
  // A cone of 45 degrees becomes narrower upwards; the sphere touches it where its normal is at 45 degrees.
  const double radius = 10 / std::sqrt(2.0);
  Part part{{plane({0, 0, 0}, -z, 1200), cone({0, 0, 5}, z, 15, -1, 900),
             sphere({0, 0, 20 - 2 * radius / std::sqrt(2.0)}, radius, 300)}};
  part.size = 40;
  Contact contact{{1, 2}, {}, true};
  const double rim = radius / std::sqrt(2.0);
  for (const Vec3& out : {x, y, -x, -y}) contact.points.push_back(Vec3(0, 0, 20 - rim) + rim * out);
  part.contacts = {contact};
  for (const Vec3& point : contact.points)
    for (const int face : {1, 2})
      ASSERT_NEAR(surfaces::signed_distance(part.faces[std::size_t(face)].surface, point), 0, 1e-9);
  MadeSheet sheet(part);
  EXPECT_EQ(sheet.needed(), 3);
  sheet.size(1, UnknownKind::angle).size(2).distance(0, 2, 0);
  EXPECT_TRUE(sheet.account().is_complete());
  expect_moves_with_part(sheet);
}

TEST(Definition, A_torus_groove_has_two_radii_and_a_place) {
  Part part{{cylinder({0, 0, 20}, z, 10, 2500), plane({0, 0, 0}, -z, 314), plane({0, 0, 40}, z, 314),
             torus({0, 0, 15}, z, 11, 3, 200)}};
  part.size = 48;
  MadeSheet sheet(part);
  EXPECT_EQ(sheet.needed(), 2 + 3);
  sheet.size(0).distance(1, 2, 1).size(3).size(3, UnknownKind::minor);
  const std::vector<std::string> said = sheet.sentences();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("torus R3 around ⌀22 face"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("can move along z"), std::string::npos) << said[0];
  sheet.distance(1, 3, 1);
  EXPECT_TRUE(sheet.account().is_complete());
}

TEST(Definition, A_fillet_on_a_shaft_has_one_radius) {
  Part part{{cylinder({0, 0, 25}, z, 10, 1500), plane({0, 0, 0}, -z, 900), plane({0, 0, 50}, z, 314),
             plane({20, 0, 10}, z, 900), cylinder({0, 0, 5}, z, 25, 1500), torus({0, 0, 12}, z, 12, 2, 150)}};
  part.size = 70;
  Contact to_wall{{0, 5}, {}, true}, to_floor{{3, 5}, {}, true};
  for (const Vec3& out : {x, y, -x, -y}) {
    to_wall.points.push_back(Vec3(0, 0, 12) + 10.0 * out);
    to_floor.points.push_back(Vec3(0, 0, 10) + 12.0 * out);
  }
  // Two diameters and two lengths.
  EXPECT_EQ(MadeSheet(part).needed(), 4 + 3);
  part.contacts = {to_wall, to_floor};
  EXPECT_EQ(MadeSheet(part).needed(), 4 + 1);
  expect_moves_with_part(MadeSheet(part));
}

TEST(Definition, A_slot_has_two_places_of_its_ends_one_across_and_a_radius) {
  MadeSheet sheet(slotted());
  EXPECT_EQ(sheet.needed(), 3 + 4);
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  sheet.distance(front, 6, front).size(6).distance(left, 6, left);
  ASSERT_EQ(sheet.account().motions.size(), 1U);
  EXPECT_EQ(sheet.account().motions[0].faces, std::vector<int>{7});
  sheet.distance(6, 7, left);
  EXPECT_TRUE(sheet.account().is_complete());
  // The width says the radius again.
  sheet.distance(8, 9, front);
  EXPECT_EQ(sheet.account().repeated, (std::vector<std::vector<int>>{{7, 4}}));
  expect_moves_with_part(sheet);
}

TEST(Definition, A_chain_of_two_radii_has_these_and_a_place) {
  // From one side to another one behind it, by a rounding and a fillet that touch where both run at 60 degrees.
  const double cosine = 0.5, sine = std::sqrt(3.0) / 2, r = 8, s = 6;
  const double step = (r + s) * (1 - cosine), run = (r + s) * sine;
  Part part = with(box({60, 40, 10}), {plane({50, 40 - step, 5}, y, 150), cylinder({20, 40 - r, 5}, z, r, 80),
                                       cylinder({20 + run, 40 - step + s, 5}, z, s, 60)});
  const Vec3 touch(20 + r * sine, 40 - r + r * cosine, 0);
  part.contacts = {{{back, 7}, {{20, 40, 0}, {20, 40, 10}}, true},
                   {{6, 8}, {{20 + run, 40 - step, 0}, {20 + run, 40 - step, 10}}, true},
                   {{7, 8}, {touch, touch + 10.0 * z}, true}};
  for (const Contact& contact : part.contacts)
    for (const int face : contact.faces)
      ASSERT_NEAR(surfaces::signed_distance(part.faces[std::size_t(face)].surface, contact.points[0]), 0, 1e-9);
  MadeSheet sheet(part);
  EXPECT_EQ(sheet.needed(), 3 + 1 + 3);
  expect_moves_with_part(sheet);
}

TEST(Definition, What_is_said_twice_is_told_with_what_says_it) {
  MadeSheet sheet(with(box({60, 40, 10}), {plane({20, 20, 8}, x, 80), plane({20, 20, 6}, z, 80)}));
  sheet.distance(left, 6, left).distance(6, right, left).distance(front, back, front).distance(left, right, left);
  EXPECT_EQ(sheet.account().repeated, (std::vector<std::vector<int>>{{3, 0, 1}}));
  EXPECT_EQ(sheet.account().states[bottom], FaceState::fixed) << "the datum, to which the top and the step move";
  sheet.angle(left, front, z);
  EXPECT_EQ(sheet.account().repeated, (std::vector<std::vector<int>>{{3, 0, 1}, {4}})) << "drawn at right angles";
}

// Of 20 and 40, which are 60 together, one text is larger by 1; with half a unit of slack in each, all may be true.
TEST(Definition, Texts_contradict_that_cannot_all_be_true) {
  MadeSheet sheet(with(box({60, 40, 10}), {plane({20, 20, 8}, x, 80), plane({20, 20, 6}, z, 80)}));
  sheet.distance(left, 6, left).distance(6, right, left).distance(front, back, front).distance(left, right, left);
  EXPECT_TRUE(sheet.account().contradictory.empty());
  sheet.dimensions[3].more = -1 / sheet.part.size;  // the direction is that of the left face, outwards
  EXPECT_EQ(sheet.account().contradictory, (std::vector<std::vector<int>>{{3, 0, 1}}));
  sheet.dimensions[0].more = -1 / sheet.part.size;
  EXPECT_TRUE(sheet.account().contradictory.empty()) << "19 and 40 are 59";
  sheet.dimensions[0].more = 0;
  for (const std::size_t number : {0, 1, 3}) sheet.dimensions[number].slack = 0.5 / sheet.part.size;
  EXPECT_TRUE(sheet.account().contradictory.empty());
}

TEST(Definition, What_may_be_said_leaves_faces_in_doubt) {
  MadeSheet sheet(box({60, 40, 10}));
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  sheet.dimensions[1].is_certain = false;
  const Account account = sheet.account();
  EXPECT_FALSE(account.is_complete());
  EXPECT_FALSE(account.is_certain);
  EXPECT_TRUE(account.motions.empty());
  EXPECT_EQ(std::count(account.states.begin(), account.states.end(), FaceState::uncertain), 1);
}

TEST(Definition, A_slope_held_at_two_places_that_nearly_coincide_cannot_be_told) {
  for (const double apart : {10.0, 0.0005}) {
    MadeSheet sheet(with(box({60, 40, 10}), {plane({55, 20, 8}, {1, 0, 1.5}, 300)}));
    sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
    for (const double off : {0.0, apart}) {
      const Vec3 at(52 + off, 20, 10 - off / 1.5);
      sheet.dimensions.push_back(
          {"height",
           {length(sheet.unknowns, sheet.part, {End{{52, 20, 0}, {bottom}}, End{at, {6, left}}}, z, bottom)}});
    }
    EXPECT_EQ(sheet.account().is_complete(), apart > 1);
    EXPECT_EQ(sheet.account().is_certain, apart > 1);
  }
}

// Six sides about z, the first one towards y, then bottom and top; the circle that touches the sides is only drawn.
TEST(Definition, A_regular_hexagon_has_a_width_and_a_height) {
  Part prism{{}, {}, 40};
  for (int side = 0; side < 6; ++side) {
    const double at = (side + 1.5) * M_PI / 3;
    const Vec3 out(std::cos(at), std::sin(at), 0);
    prism.faces.push_back(plane(15.0 * out + 10.0 * z, out, 300));
  }
  prism = with(prism, {plane({0, 0, 0}, -z, 700), plane({0, 0, 20}, z, 700), cylinder({0, 0, 10}, z, 15, 0)});
  EXPECT_EQ(MadeSheet(prism).needed() - 3, 7);  // beside the circle: four places, two angles, a height
  MadeSheet sheet(prism, Marks{.hexagons = {{8, {0, 1, 2, 3, 4, 5}}}});
  EXPECT_EQ(sheet.needed(), 2);
  sheet.distance(0, 3, 0).distance(6, 7, 6);
  EXPECT_TRUE(sheet.account().is_complete());
  expect_moves_with_part(sheet);
}

TEST(Definition, A_hole_whose_centre_line_crosses_that_of_a_tube_has_a_place_and_a_diameter) {
  const auto tube = [&](double off) {
    Part part{{cylinder({0, 0, 20}, z, 20, 5000), plane({0, 0, 0}, -z, 600), plane({0, 0, 40}, z, 600),
               cylinder(Vec3(15, 8, 12) + off * Vec3(8, -15, 0), {15, 8, 0}, 3, 200)}};
    part.size = 70;
    return part;
  };
  MadeSheet sheet(tube(0));
  EXPECT_EQ(sheet.needed(), 2 + 2);
  EXPECT_EQ(MadeSheet(tube(0.1)).needed(), 2 + 3);
  expect_moves_with_part(sheet);
}

TEST(Definition, Axes_behind_each_other_in_a_view_are_one_line) {
  const auto wedge = [](double off) {
    const Vec3 out(-0.6, 0, 0.8), along(0.8, 0, 0.6);
    return with(box({60, 40, 50}), {plane(Vec3(30, 20, 30), out, 2500), cylinder(Vec3(30, 10, 30), out, 3, 200),
                                    cylinder(Vec3(30, 30, 30) + off * along, out, 3, 200)});
  };
  MadeSheet sheet(wedge(0));
  EXPECT_EQ(sheet.needed() + 1, MadeSheet(wedge(2)).needed());
  expect_moves_with_part(sheet);
}

TEST(Definition, A_free_form_is_given_by_the_model) {
  Part part = box({60, 40, 10});
  part.faces.push_back({{}, {20, 20, 10}, 50});
  MadeSheet sheet(part);
  sheet.distance(left, right, left).distance(front, back, front).distance(bottom, top, bottom);
  EXPECT_EQ(sheet.account().states[6], FaceState::by_model);
  EXPECT_TRUE(sheet.account().is_complete());
}

// Rows of three unknowns that overlap: one group, too large for dense matrices.
TEST(Definition, Ranks_of_large_groups_are_proved) {
  constexpr int count = 4000;
  std::vector<Row> rows;
  for (int i = 0; i + 2 < count; ++i) rows.push_back({{i, 0.8}, {i + 1, 0.5}, {i + 2, 0.33}});
  const NullSpace two = null_space(count, rows);
  EXPECT_EQ(two.vectors.size(), 2U);
  EXPECT_TRUE(two.is_certain);
  for (const Row& row : rows)
    for (const Row& vector : two.vectors) {
      double sum = 0;
      for (const Term& term : row)
        for (const Term& other : vector)
          if (other.unknown == term.unknown) sum += term.factor * other.factor;
      ASSERT_NEAR(sum, 0, 1e-6);
    }
  rows.push_back({{count - 3, 0.6}, {count - 2, 0.5}, {count - 1, 0.6}});
  EXPECT_EQ(null_space(count, rows).vectors.size(), 1U);
  rows.push_back({{count - 3, 0.6}, {count - 2, 0.5 + 1e-5}, {count - 1, 0.6}});
  const NullSpace nearly = null_space(count, rows);
  EXPECT_FALSE(nearly.is_certain) << "the last two rows are nearly one";
}

// Each is a row that some part needs: without it, the part has more sizes.
TEST(Definition, Rules_are_switched_off_one_by_one) {
  const Part part = box({60, 40, 10});
  const auto sizes = [&part](const RuleSet& applied) { return MadeSheet(part, {}, applied).account().needed; };
  RuleSet parallel_only;
  for (std::size_t i = 0; i < rule_count; ++i)
    if (std::string(all_rules()[i].name) == "parallel") parallel_only.set(i);
  EXPECT_EQ(sizes(rules_of(Standard::iso)), 3);
  EXPECT_EQ(sizes(rules_of(Standard::asme)), 3);
  EXPECT_EQ(sizes(parallel_only), 6) << "three angles between its directions, too";
  EXPECT_EQ(sizes(rules_of(Standard::iso) & ~parallel_only), 3 + 6) << "three of the faces turn about two axes";
  EXPECT_EQ(sizes(rules_of(Standard::none)), 6 * 3 - 6);
}

TEST(Definition, Each_rule_tells_its_mark_and_its_source) {
  for (const Rule& rule : all_rules()) {
    EXPECT_EQ(rule.clause[0], nullptr) << rule.name;
    EXPECT_NE(rule.clause[1], nullptr) << rule.name;
    EXPECT_FALSE(std::string(rule.mark).empty()) << rule.name;
  }
}

}  // namespace epura::definition::closed_forms_test
