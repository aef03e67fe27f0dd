// SPDX-License-Identifier: Apache-2.0
// Dimensions of faces that belong to no feature which has dimensions of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "dimensioned_part.hpp"
#include "known_parts.hpp"
#include "sizes/coordinates.hpp"

namespace epura::test::free_face_dimensions_test {
namespace {

/// An arc about a point, from one direction to another, in degrees.
Loop arc(const Vec2& centre, double radius, double from, double to, int steps = 24) {
  Loop points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = (from + (to - from) * i / steps) * std::numbers::pi / 180;
    points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

// 60 x 40, 40 deep; a bulge of the radius leaves the right side, about a point within.
std::string bulged_block(const Vec2& centre, double radius) {
  const double half = std::acos((60 - centre.x) / radius) * 180 / std::numbers::pi;
  Loop outline{{0, 0}, {60, 0}};
  for (const Vec2& point : arc(centre, radius, -half, half)) outline.push_back(point);
  outline.push_back({60, 40});
  outline.push_back({0, 40});
  return block(outline, 40);
}

// 60 wide, 40 deep; the top is an arc between the sides.
std::string crowned_block(const Vec2& centre, double radius) {
  const auto angle = [&](double x) { return std::acos((x - centre.x) / radius) * 180 / std::numbers::pi; };
  Loop outline{{0, 0}, {60, 0}};
  for (const Vec2& point : arc(centre, radius, angle(60), angle(0))) outline.push_back(point);
  return block(outline, 40);
}

double angle_of(const Vec2& direction) { return std::atan2(direction.y, direction.x) * 180 / std::numbers::pi; }

// A boss at the origin and a smaller one, 8 thick, with an arm between them that grows from half of the width to half
// of the other one where its sides meet the bosses, perhaps behind fillets, turned by an angle.
std::string lever(double turn, double half, double other, double fillet = 0) {
  constexpr double large = 15, small = 10, length = 60;
  const std::array<Vec2, 2> centres{Vec2(length, 0), Vec2(0, 0)};
  const std::array<Vec2, 2> corners{Vec2(length - std::sqrt(small * small - other * other), other),
                                    Vec2(std::sqrt(large * large - half * half), half)};
  const Vec2 along = glm::normalize(corners[1] - corners[0]), up(along.y, -along.x);
  Loop side;  // above, from the small boss to the large one
  for (const std::size_t end : {0U, 1U}) {
    if (!(fillet > 0)) {
      side.push_back(corners[end]);
      continue;
    }
    const double above = glm::dot(corners[end] - centres[end], up) + fillet, out = (end == 0 ? small : large) + fillet;
    const Vec2 centre = centres[end] + above * up + (end == 0 ? 1 : -1) * std::sqrt(out * out - above * above) * along;
    const double at_boss = angle_of(centres[end] - centre), at_side = angle_of(-up);
    const double sweep = std::remainder(at_side - at_boss, 360);
    Loop arc_at_end = arc(centre, fillet, at_boss, at_boss + sweep);
    if (end == 1) std::reverse(arc_at_end.begin(), arc_at_end.end());
    side.insert(side.end(), arc_at_end.begin(), arc_at_end.end());
  }
  const double at_large = angle_of(side.back()), at_small = angle_of(side.front() - centres[0]);
  Loop outline = arc(centres[1], large, at_large, 360 - at_large, 72);
  for (auto point = side.rbegin(); point != side.rend(); ++point) outline.emplace_back(point->x, -point->y);
  for (const Vec2& point : arc(centres[0], small, -at_small, at_small, 72)) outline.push_back(point);
  outline.insert(outline.end(), side.begin(), side.end());
  // Ends of arcs are there twice.
  const auto is_same = [](const Vec2& a, const Vec2& b) { return glm::distance(a, b) < 1e-9; };
  outline.erase(std::unique(outline.begin(), outline.end(), is_same), outline.end());
  if (is_same(outline.front(), outline.back())) outline.pop_back();
  for (Vec2& point : outline)
    point = {cosine(turn) * point.x - sine(turn) * point.y, sine(turn) * point.x + cosine(turn) * point.y};
  return block(outline, 8);
}

// How many of its dimensions are missed if they are left out.
std::size_t needed(const DimensionedPart& sheet) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sheet.texts.size(); ++i)
    if (!sheet.free_without(i).free.empty()) ++count;
  return count;
}

void expect_defined(const DimensionedPart& sheet, const std::string& name) {
  const Said free = sheet.free();
  for (const sheet::FreeFace& one : free.free) ADD_FAILURE() << name << ": " << one.sentence;
  for (const std::string& one : free.undecided) ADD_FAILURE() << name << ": " << one;
  EXPECT_EQ(free.count.given, free.count.all) << name;
  EXPECT_TRUE(free.contradictory.empty() && free.undecided.empty()) << name;
  EXPECT_EQ(needed(sheet), sheet.texts.size()) << name << ": each is needed";
  const auto rebuilt = sheet.rebuilt();
  ASSERT_TRUE(rebuilt) << name;
  EXPECT_TRUE(rebuilt->is_defined()) << name;
}

// A round bar with notches all around, as of a knurl.
Loop knurl(int count, double tip, double root, double half) {
  Loop outline;
  for (int i = 0; i < count; ++i) {
    const double at = 360.0 * i / count, next = 360.0 * (i + 1) / count;
    outline.push_back(root * Vec2(cosine(at), sine(at)));
    for (const Vec2& point : arc({0, 0}, tip, at + half, next - half)) outline.push_back(point);
  }
  return outline;
}

// A block of 60 x 40 x 30 of whose corner a plane cuts off lengths along its edges.
std::string block_without_corner(const Vec3& cut) {
  const Vec3 a(60 - cut.x, 40, 30), b(60, 40 - cut.y, 30), c(60, 40, 30 - cut.z);
  Model model;
  model.face({{0, 0, 0}, {0, 40, 0}, {60, 40, 0}, {60, 0, 0}});
  model.face({{0, 0, 0}, {60, 0, 0}, {60, 0, 30}, {0, 0, 30}});
  model.face({{0, 0, 0}, {0, 0, 30}, {0, 40, 30}, {0, 40, 0}});
  model.face({{0, 0, 30}, {60, 0, 30}, b, a, {0, 40, 30}});
  model.face({{60, 0, 0}, {60, 40, 0}, c, b, {60, 0, 30}});
  model.face({{0, 40, 0}, {0, 40, 30}, a, c, {60, 40, 0}});
  model.face({a, b, c});
  return model.obj();
}

// A block of 60 x 40 x 20 with a hole through it that leans in the plane of x and z; its axis leaves the top at (25,
// 15).
std::string block_with_leaning_hole(double degrees) {
  const Vec3 axis(sine(degrees), 0, cosine(degrees)), out(25, 15, 20);
  const Loop border = square({0, 0}, {60, 40}), round = circle({0, 0}, 4, -135);
  const auto at = [&](std::size_t i, double z) {
    const Vec3 side = out + round[i].x * Vec3(axis.z, 0, -axis.x) + Vec3(0, round[i].y, 0);
    return side + (z - side.z) / axis.z * axis;
  };
  Model model;
  for (std::size_t p = 0; p < border.size(); ++p) {
    const std::size_t q = (p + 1) % border.size();
    model.face({Vec3(border[p], 20), Vec3(border[q], 20), at(q, 20), at(p, 20)});
    model.face({at(p, 20), at(q, 20), at(q, 0), at(p, 0)});
    model.face({at(p, 0), at(q, 0), Vec3(border[q], 0), Vec3(border[p], 0)});
    model.face({Vec3(border[q], 20), Vec3(border[p], 20), Vec3(border[p], 0), Vec3(border[q], 0)});
  }
  return model.obj();
}

// Its width, and for a tapering one that at either end, is all that an arm has beside what gives its bosses and
// fillets.
TEST(FreeFaceDimensions, SidesOfAnArmAreAboutTheLineOfCentres) {
  for (const double fillet : {0.0, 3.0})
    for (const double turn : {0.0, 30.0, 55.0, 110.0})
      for (const double other : {5.0, 7.0}) {
        const std::string name = "a lever turned by " + std::to_string(turn) + ", " + std::to_string(other) +
                                 ", fillets " + std::to_string(fillet);
        const DimensionedPart sheet(lever(turn, 5, other, fillet));
        const sheet::FreeFaces free = sheet.free();
        EXPECT_EQ(free.count.given, free.count.all) << name;
        EXPECT_TRUE(free.contradictory.empty() && free.undecided.empty()) << name;
        // Thickness, two bosses, their distance along one axis or two. Overall sizes stand in brackets.
        const std::size_t expected = 4 + (turn > 0 ? 1U : 0U) + (other > 5 ? 2U : 1U) + (fillet > 0 ? 1U : 0U);
        EXPECT_EQ(needed(sheet), expected) << name;
        EXPECT_EQ(std::ranges::count_if(sheet.texts, [](const std::string& text) { return !text.starts_with('('); }),
                  static_cast<std::ptrdiff_t>(expected))
            << name;
        // A straight arm along an axis has a linear dimension.
        const std::vector<double> aligned = sheet.lengths_of(DimensionType::aligned);
        EXPECT_EQ(std::ranges::count(aligned, 10.0), turn > 0 || other > 5 ? 1 : 0) << name;
        EXPECT_EQ(std::ranges::count(aligned, 14.0), other > 5 ? 1 : 0) << name;
      }
}

}  // namespace

// A notch in one side of a plate that is turned as a whole has its places along the sides.
TEST(FreeFaceDimensions, OfATurnedPartAreAlongItsOwnAxes) {
  for (const double turn : {20.0, 27.0, 63.0}) {
    Loop outline{{0, 0}, {60, 0}, {60, 40}, {41, 40}, {32, 29}, {22, 40}, {0, 40}};
    for (Vec2& point : outline)
      point = {cosine(turn) * point.x - sine(turn) * point.y, sine(turn) * point.x + cosine(turn) * point.y};
    const DimensionedPart sheet(block(outline, 8));
    const sheet::FreeFaces free = sheet.free();
    EXPECT_EQ(free.count.given, free.count.all) << turn;
    EXPECT_TRUE(sheet.lengths_of(DimensionType::linear).empty()) << turn;
    EXPECT_EQ(sheet.lengths_of(DimensionType::overall).size(), 1U) << turn << ": the thickness";
  }
}

// By the three lengths that it leaves of the edges, which no view shows square to it.
TEST(FreeFaceDimensions, GiveACornerThatIsCutOff) {
  for (const Vec3& cut : {Vec3(10, 10, 10), Vec3(20, 12, 8), Vec3(9, 15, 22)}) {
    const DimensionedPart sheet(block_without_corner(cut));
    expect_defined(sheet, "a corner");
    EXPECT_EQ(sheet.texts.size(), 6U) << testing::PrintToString(sheet.texts);
  }
}

// Where its axis meets the top, at which angle, and its diameter.
TEST(FreeFaceDimensions, GiveAHoleThatLeans) {
  for (const double degrees : {20.0, 30.0, -35.0}) {
    const DimensionedPart sheet(block_with_leaning_hole(degrees));
    expect_defined(sheet, "leaning by " + std::to_string(degrees));
    EXPECT_EQ(sheet.texts.size(), 7U) << testing::PrintToString(sheet.texts);
  }
}

// Width, height, depth, the radius and the place of its centre; how far the bulge goes out follows.
TEST(FreeFaceDimensions, GiveTheHeightOfABulge) {
  for (int i = 0; i < 6; ++i) {
    const DimensionedPart sheet(bulged_block({50.0 + i, 15.0 + i}, 14 + 0.5 * i));
    expect_defined(sheet, "a bulge " + std::to_string(i));
    EXPECT_EQ(sheet.texts.size(), 6U) << i;
  }
}

TEST(FreeFaceDimensions, GiveThePlaceOfACrown) {
  for (int i = 0; i < 6; ++i) {
    const DimensionedPart sheet(crowned_block({22.0 + i, -20.0 + i}, 50));
    expect_defined(sheet, "a crown " + std::to_string(i));
  }
}

// Nobody dimensions each flank of a knurl: those that are too many are told.
TEST(FreeFaceDimensions, LeaveOutPatternsOfFaces) {
  for (const int count : {10, 14, 16}) {
    const DimensionedPart sheet(block(knurl(count, 15, 13.6, 5), 30));
    EXPECT_LE(sheet.texts.size(), 6U) << count;
    std::size_t told = 0;
    for (const auto& [view, number] : sheet.omitted.too_many) told += number;
    EXPECT_GT(told, sheet::max_parallel) << count;
    EXPECT_FALSE(sheet.free().free.empty()) << count;
  }
}

// Sides that lean alike have one angle between them, with their number.
TEST(FreeFaceDimensions, GiveEqualSlopesOneAngle) {
  for (const double degrees : {35.0, 65.0}) {
    const double in = 20 / std::tan(degrees * std::numbers::pi / 180);
    const DimensionedPart sheet(block({{0, 0}, {70, 0}, {70, 10}, {70 - in, 30}, {in, 30}, {0, 10}}, 25));
    expect_defined(sheet, "slopes of " + std::to_string(degrees));
    EXPECT_EQ(std::ranges::count(sheet.texts, "2× <>"), 1) << degrees;
  }
}

}  // namespace epura::test::free_face_dimensions_test
