// SPDX-License-Identifier: Apache-2.0
#include "annotations/hatch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "drawing/drawing.hpp"

namespace epura::hatch_test {
namespace {

using Ring = std::vector<Vec2>;

Ring rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Ring turned(const Ring& ring, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  Ring result;
  for (const Vec2& p : ring) result.emplace_back(c * p.x - s * p.y, s * p.x + c * p.y);
  return result;
}

Ring circle(double radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.emplace_back(radius * std::cos(2 * std::numbers::pi * i / corners),
                      radius * std::sin(2 * std::numbers::pi * i / corners));
  return ring;
}

drawing::ViewDrawing drawing_of(std::vector<drawing::CutFace> faces) {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  drawing.cuts.faces = std::move(faces);
  return drawing;
}

std::vector<sheet::Hatching> choose(const drawing::ViewDrawing& drawing) {
  const drawing::ViewDrawing* pointer = &drawing;
  return sheet::choose_hatching({&pointer, 1});
}

const sheet::BodyStyles plain{{{{}}, {{}}}};

sheet::Layer hatched(const drawing::ViewDrawing& drawing) {
  return sheet::hatch_layer({drawing, plain}, choose(drawing), {0.5, 0.25});
}

// A square of 40 mm, hatched at a pitch of 2 mm.
sheet::Layer hatched_square(HatchPattern pattern) {
  const drawing::ViewDrawing drawing = drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}}});
  sheet::BodyStyle style;
  style.hatch = {pattern, 30, 2};
  const sheet::BodyStyles styles{{{style}}};
  const drawing::ViewDrawing* pointer = &drawing;
  const auto wish = [&](std::size_t, int model, int body) { return styles(model, body).hatch; };
  const std::vector<sheet::Hatching> hatching = sheet::choose_hatching({&pointer, 1}, wish);
  EXPECT_EQ(hatching.at(0).angle, 30);
  EXPECT_EQ(hatching.at(0).spacing, 2);
  return sheet::hatch_layer({drawing, styles}, hatching, {0.5, 0.25});
}

double ink(const sheet::Layer& layer) {
  double length = 0;
  for (const sheet::Stroke& stroke : layer.strokes) length += glm::distance(stroke.points[0], stroke.points[1]);
  return length;
}

TEST(Hatch, IsInterruptedAtTexts) {
  // A text of 10 mm by 4 mm, with 0.7 mm around it.
  const drawing::ViewDrawing drawing = drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}}});
  const std::vector<sheet::Hatching> hatching = choose(drawing);
  const sheet::TurnedBox text{{20, 20}, {1, 0}, {5, 2}};
  const sheet::Layer whole = hatched(drawing),
                     layer = sheet::hatch_layer({drawing, plain, {&text, 1}}, hatching, {0.5, 0.25});
  const double spacing = hatching.at(0).spacing;
  EXPECT_NEAR(ink(whole) - ink(layer), 11.4 * 5.4 / spacing, 5.4 * std::sqrt(2.0));
  for (const sheet::Stroke& stroke : layer.strokes) {
    const Vec2 middle = (stroke.points[0] + stroke.points[1]) / 2.0;
    EXPECT_FALSE(sheet::overlap(sheet::line_box(stroke.points[0], stroke.points[1]), text))
        << middle.x << ' ' << middle.y;
  }
}

// As a whole, for other programs, the face has islands where texts are; it is lines only where that cannot be told.
TEST(Hatch, HasIslandsAtTexts) {
  const drawing::ViewDrawing drawing = drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}}});
  const auto rings_with = [&](const std::vector<sheet::TurnedBox>& texts) {
    const sheet::Layer layer = sheet::hatch_layer({drawing, plain, texts}, choose(drawing), {0.5, 0.25});
    return layer.hatched.empty() ? std::vector<std::vector<Vec2>>() : layer.hatched.front().face.rings;
  };
  const auto area = [](const std::vector<Vec2>& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
    return std::abs(sum);
  };
  const sheet::TurnedBox text{{20, 20}, {1, 0}, {5, 2}}, below{{19, 15}, {1, 0}, {4, 2}},
      upright{{30, 10}, {0, 1}, {5, 2}};
  EXPECT_EQ(rings_with({}).size(), 1U);
  ASSERT_EQ(rings_with({text}).size(), 2U);
  EXPECT_NEAR(area(rings_with({text})[1]), 11.4 * 5.4, 1e-9);
  EXPECT_EQ(rings_with({text, upright}).size(), 3U);
  ASSERT_EQ(rings_with({text, below}).size(), 2U) << "two lines of a note";
  EXPECT_NEAR(area(rings_with({text, below})[1]), 11.4 * 10.4, 1e-9);
  EXPECT_EQ(rings_with({{{60, 20}, {1, 0}, {5, 2}}}).size(), 1U) << "beside the face";
  EXPECT_EQ(rings_with({{{38, 20}, {1, 0}, {5, 2}}}).size(), 0U) << "across its outline";
  EXPECT_EQ(rings_with({text, {{20, 20}, {0, 1}, {5, 2}}}).size(), 0U) << "two texts across each other";
}

TEST(Hatch, LengthOfLinesIsAreaBySpacing) {
  const double disc = 100 * std::sin(2 * std::numbers::pi / 200) * 900;
  const std::vector<std::pair<drawing::CutFace, double>> faces = {
      {{0, 0, {rectangle(0, 0, 80, 60)}}, 4800},
      {{0, 0, {rectangle(0, 0, 80, 60), rectangle(10, 10, 50, 50)}}, 3200},
      {{0, 0, {rectangle(0, 0, 80, 60), rectangle(10, 10, 50, 50), rectangle(20, 20, 30, 30)}}, 3300},
      {{0, 0, {circle(30, 200)}}, disc}};
  for (const auto& [face, area] : faces) {
    const drawing::ViewDrawing drawing = drawing_of({face});
    const sheet::Hatching hatching = choose(drawing).at(0);
    EXPECT_EQ(hatching.angle, 45);
    const sheet::Layer layer = hatched(drawing);
    EXPECT_EQ(layer.name, "front/hatch");
    EXPECT_EQ(layer.style.width, 0.25);
    EXPECT_TRUE(layer.fills.empty());
    EXPECT_NEAR(ink(layer) * hatching.spacing / area, 1, 0.02);
  }
}

// A band of half the width of a square lies in front of it; a small part in front of the band changes nothing.
TEST(Hatch, IsOutsideOfWhatLiesInFront) {
  drawing::ViewDrawing drawing = drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}}});
  const double spacing = choose(drawing).at(0).spacing;
  drawing.cuts.before = {{Vec2(10, -1), Vec2(30, -1), Vec2(30, 41)}, {Vec2(10, -1), Vec2(30, 41), Vec2(10, 41)}};
  const double ink_beside = ink(hatched(drawing));
  EXPECT_NEAR(ink_beside * spacing / 800, 1, 0.02);
  drawing.cuts.before.push_back({Vec2(16, 14), Vec2(20, 14), Vec2(18, 22)});
  EXPECT_NEAR(ink(hatched(drawing)), ink_beside, 1e-9);
}

TEST(Hatch, EndsExactlyAtOutlinesAlsoAtCorners) {
  // Corners lie on hatching lines: x - y is a multiple of the spacing times the root of 2.
  const drawing::ViewDrawing probe = drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}}});
  const double step = choose(probe).at(0).spacing * std::sqrt(2);
  const double a = 40 * step;
  const drawing::ViewDrawing drawing = drawing_of({{0, 0, {{{0, 0}, {a, 0}, {a, a}, {a / 2, a / 2}, {0, a}}}}});
  const sheet::Hatching same{0, 0, 45, step / std::sqrt(2)};
  const sheet::Layer layer = sheet::hatch_layer({drawing, plain}, {&same, 1}, {0.5, 0.25});
  for (const sheet::Stroke& stroke : layer.strokes)
    for (const Vec2& p : stroke.points) {
      const bool on_outline = std::abs(p.y) < 1e-9 || std::abs(p.x - a) < 1e-9 || std::abs(p.x) < 1e-9 ||
                              std::abs(p.x - p.y) < 1e-9 || std::abs(p.x + p.y - a) < 1e-9;
      EXPECT_TRUE(on_outline) << p.x << " " << p.y;
    }
  EXPECT_NEAR(ink(layer) * same.spacing / (0.75 * a * a), 1, 0.02);
}

TEST(Hatch, DoesNotRunAlongTheOutline) {
  EXPECT_EQ(choose(drawing_of({{0, 0, {turned(rectangle(0, 0, 60, 10), 45)}}})).at(0).angle, 30);
  EXPECT_EQ(choose(drawing_of({{0, 0, {turned(rectangle(0, 0, 60, 10), 135)}}})).at(0).angle, 30);
  EXPECT_EQ(choose(drawing_of({{0, 0, {rectangle(0, 0, 60, 10)}}})).at(0).angle, 45);
}

TEST(Hatch, OfTouchingPartsDiffersAndOfOnePartIsTheSame) {
  const drawing::ViewDrawing drawing = drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}},
                                                   {0, 1, {rectangle(40, 0, 80, 40)}},
                                                   {0, 2, {rectangle(0, 40, 80, 80)}},
                                                   {1, 0, {rectangle(200, 0, 240, 40)}},
                                                   {1, 1, {rectangle(10, 10, 30, 30)}}});
  const std::vector<sheet::Hatching> hatching = choose(drawing);
  ASSERT_EQ(hatching.size(), 5U);
  const auto differ = [&](std::size_t i, std::size_t j) {
    return hatching[i].angle != hatching[j].angle ||
           std::abs(std::log(hatching[i].spacing / hatching[j].spacing)) > std::log(1.39);
  };
  EXPECT_TRUE(differ(0, 1) && differ(0, 2) && differ(1, 2) && differ(0, 4));
  EXPECT_EQ(hatching[0].angle, 45);
  EXPECT_EQ(hatching[1].angle, 135);
  EXPECT_EQ(hatching[3].angle, 45);

  drawing::ViewDrawing other = drawing_of({{0, 1, {rectangle(0, 0, 7, 7)}}});
  other.name = "left";
  const std::array both{&drawing, static_cast<const drawing::ViewDrawing*>(&other)};
  const std::vector<sheet::Hatching> of_both = sheet::choose_hatching(both);
  EXPECT_EQ(of_both.size(), 5U);
  EXPECT_EQ(of_both[1].angle, hatching[1].angle);
  EXPECT_EQ(of_both[1].spacing, hatching[1].spacing);
}

// Whichever comes first: a corner of one near a side of the other, and one part inside the other.
TEST(Hatch, OfTouchingPartsDiffersFromBothSides) {
  const Ring square = rectangle(0, 0, 40, 40);
  for (const Ring& other : {Ring{{40.5, 20}, {70, 10}, {70, 30}}, Ring{{20, -0.5}, {30, -30}, {10, -30}},
                            Ring{{-0.5, 20}, {-30, 30}, {-30, 10}}, rectangle(10, 10, 30, 30)})
    for (const bool first : {false, true}) {
      const auto hatching = choose(drawing_of({{0, first ? 0 : 1, {square}}, {0, first ? 1 : 0, {other}}}));
      ASSERT_EQ(hatching.size(), 2U);
      EXPECT_NE(hatching[0].angle, hatching[1].angle);
    }
  const Ring apart{{41, 20}, {70, 10}, {70, 30}};
  const auto hatching = choose(drawing_of({{0, 0, {square}}, {0, 1, {apart}}}));
  EXPECT_EQ(hatching[0].angle, hatching[1].angle);
}

TEST(Hatch, HasThePatternOfTheStyle) {
  const double lines = 1600 / 2.0;  // area by pitch
  EXPECT_NEAR(ink(hatched_square(HatchPattern::general)) / lines, 1, 0.02);
  EXPECT_NEAR(ink(hatched_square(HatchPattern::steel)) / lines, 2, 0.04);
  EXPECT_NEAR(ink(hatched_square(HatchPattern::bronze)) / lines, 1, 0.02);
  EXPECT_NEAR(ink(hatched_square(HatchPattern::nonmetal)) / lines, 2, 0.04);
  const sheet::Layer bronze = hatched_square(HatchPattern::bronze);
  const auto is_dashed = [](const sheet::Stroke& stroke) { return stroke.dashes.dash > 0; };
  const auto dashed = std::count_if(bronze.strokes.begin(), bronze.strokes.end(), is_dashed);
  EXPECT_NEAR(static_cast<double>(dashed) / static_cast<double>(bronze.strokes.size()), 0.5, 0.1);
  const sheet::Layer none = hatched_square(HatchPattern::none), solid = hatched_square(HatchPattern::solid);
  EXPECT_TRUE(none.strokes.empty() && none.fills.empty());
  EXPECT_TRUE(solid.strokes.empty());
  EXPECT_EQ(solid.fills.size(), 1U);
}

TEST(Hatch, OfPartsBesideAStyleAvoidsIt) {
  const drawing::ViewDrawing drawing =
      drawing_of({{0, 0, {rectangle(0, 0, 40, 40)}}, {0, 1, {rectangle(40, 0, 80, 40)}}});
  const drawing::ViewDrawing* pointer = &drawing;
  const auto wish = [&](std::size_t, int, int body) {
    return body == 1 ? sheet::HatchStyle{{}, 45, {}} : sheet::HatchStyle();
  };
  const std::vector<sheet::Hatching> hatching = sheet::choose_hatching({&pointer, 1}, wish);
  EXPECT_EQ(hatching.at(0).angle, 135);
  EXPECT_EQ(hatching.at(1).angle, 45);
}

TEST(Hatch, GoesOnAcrossAStep) {
  const drawing::ViewDrawing stepped = drawing_of({{0, 0, {rectangle(0, 0, 30, 40), rectangle(30, 0, 80, 40)}}});
  const drawing::ViewDrawing straight = drawing_of({{0, 0, {rectangle(0, 0, 80, 40)}}});
  EXPECT_EQ(hatched(stepped).strokes.size(), hatched(straight).strokes.size());
  EXPECT_NEAR(ink(hatched(stepped)), ink(hatched(straight)), 1e-9);
}

// The angle and spacing at each place, whatever number the body there has.
std::map<double, std::pair<double, double>> by_place(const std::vector<drawing::CutFace>& faces) {
  const std::vector<sheet::Hatching> hatching = choose(drawing_of(faces));
  std::map<double, std::pair<double, double>> found;
  for (const drawing::CutFace& face : faces)
    for (const sheet::Hatching& h : hatching)
      if (h.model == face.model && h.body == face.body)
        found[face.rings[0][0].x + 1000 * face.rings[0][0].y] = {h.angle, h.spacing};
  return found;
}

TEST(Hatch, DoesNotDependOnTheNumbersOfBodies) {
  std::vector<drawing::CutFace> faces = {{0, 0, {rectangle(0, 0, 40, 40)}},
                                         {0, 1, {rectangle(40, 0, 80, 40)}},
                                         {0, 2, {rectangle(0, 40, 80, 80)}},
                                         {0, 3, {rectangle(80, 0, 85, 80)}},
                                         {0, 4, {rectangle(10, 10, 30, 30)}}};
  const auto expected = by_place(faces);
  ASSERT_EQ(expected.size(), faces.size());
  std::vector<int> order{0, 1, 2, 3, 4};
  do {
    std::vector<drawing::CutFace> others = faces;
    for (std::size_t i = 0; i < faces.size(); ++i) others[i].body = order[i];
    EXPECT_EQ(by_place(others), expected);
  } while (std::next_permutation(order.begin(), order.end()));
}

// Rounding of the places must not decide either: two parts of one height, one of them lower by less than is seen.
TEST(Hatch, DoesNotDependOnRounding) {
  const auto angles = [](double shift) {
    const auto found = by_place({{0, 0, {rectangle(0, 0, 40, 40)}}, {0, 1, {rectangle(shift, 40, 40, 80)}}});
    return std::pair(found.begin()->second.first, found.rbegin()->second.first);
  };
  EXPECT_EQ(angles(1e-13), angles(0));
  EXPECT_EQ(angles(-1e-13), angles(0));
  // The side of a square at which the spacing changes.
  const auto spacing = [](double side) { return choose(drawing_of({{0, 0, {rectangle(0, 0, side, side)}}})).at(0); };
  EXPECT_EQ(spacing(18).spacing, spacing(18 - 1e-13).spacing);
  EXPECT_EQ(spacing(18).spacing, spacing(18 + 1e-13).spacing);
}

TEST(Hatch, SpacingGrowsWithTheFaceWithinLimits) {
  double last = 0;
  for (const double side : {3.0, 10.0, 30.0, 60.0, 200.0}) {
    const double spacing = choose(drawing_of({{0, 0, {rectangle(0, 0, side, side)}}})).at(0).spacing;
    EXPECT_GE(spacing, std::max(last, 0.7));
    EXPECT_LE(spacing, 4);
    last = spacing;
  }
  EXPECT_EQ(last, 4);
}

TEST(Hatch, ThinSectionsAreBlack) {
  const sheet::Layer layer =
      hatched(drawing_of({{0, 0, {rectangle(0, 0, 50, 0.8)}}, {0, 1, {rectangle(0, 5, 50, 15)}}}));
  ASSERT_EQ(layer.fills.size(), 1U);
  EXPECT_EQ(layer.fills[0].rings, std::vector<Ring>({rectangle(0, 0, 50, 0.8)}));
  EXPECT_FALSE(layer.strokes.empty());
}

}  // namespace
}  // namespace epura::hatch_test
