// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: where centre lines lie, and what they are covered by.
#include "annotations/centre_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "drawing/drawing.hpp"
#include "sheet/dash.hpp"

namespace epura::centre_lines_test {
namespace {

constexpr sheet::LineWidths widths{0.5, 0.25};

using Round = features::CentredRound;

Round circle(Vec3 centre, Vec3 axis, double radius, std::vector<int> vertices = {}) {
  return {0, axis, {{centre, radius}}, std::move(vertices)};
}

// A view whose page has x and y (right and up) along two directions of the world.
drawing::ViewDrawing view(Vec3 right, Vec3 up) {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  const Vec3 towards = glm::cross(right, up);
  drawing.world_to_page = rows(Vec4(right, 0), Vec4(up, 0), Vec4(towards, 0), Vec4(0, 0, 0, 1));
  return drawing;
}

const drawing::ViewDrawing top = view({1, 0, 0}, {0, 1, 0});
const drawing::ViewDrawing front = view({1, 0, 0}, {0, 0, 1});

struct Span {
  Vec2 from, to;
};

// Ends of the lines, each from its lower left end, in order.
std::vector<Span> spans(const sheet::Layer& layer) {
  std::vector<Span> all;
  const auto less = [](const Vec2& a, const Vec2& b) {
    return std::abs(a.x - b.x) > 1e-3 ? a.x < b.x : a.y < b.y - 1e-3;
  };
  for (const sheet::Stroke& stroke : layer.strokes) {
    Span span{stroke.points.at(0), stroke.points.at(1)};
    if (less(span.to, span.from)) std::swap(span.from, span.to);
    all.push_back(span);
  }
  std::sort(all.begin(), all.end(), [&](const Span& a, const Span& b) { return less(a.from, b.from); });
  return all;
}

void expect_spans(const sheet::Layer& layer, const std::vector<Span>& wanted) {
  const std::vector<Span> found = spans(layer);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT(glm::distance(found[i].from, wanted[i].from), 1e-3)
        << i << " " << found[i].from.x << " " << found[i].from.y;
    EXPECT_LT(glm::distance(found[i].to, wanted[i].to), 1e-3) << i << " " << found[i].to.x << " " << found[i].to.y;
  }
}

sheet::Layer lines(const drawing::ViewDrawing& drawing, const features::CentredFeatures& features,
                   const std::vector<sheet::Layer>& drawn = {}, HiddenLines hidden = HiddenLines::dashed) {
  const sheet::BodyStyles styles{{{{LineRole::visible, hidden, {}, {}}}}};
  return sheet::centre_lines({drawing, features, styles}, widths, drawn);
}

sheet::Layer lines(const drawing::ViewDrawing& drawing, const std::vector<Round>& round,
                   const std::vector<sheet::Layer>& drawn = {}) {
  return lines(drawing, features::CentredFeatures{round, {}, {}, {}}, drawn);
}

TEST(CentreLines, OfACircleAreACross) {
  const sheet::Layer layer = lines(top, {circle({30, 20, 5}, {0, 0, 1}, 10)});
  EXPECT_EQ(layer.name, "front/centre");
  EXPECT_EQ(layer.style.width, 0.25);
  EXPECT_EQ(layer.style.dashes.dots, 1);
  expect_spans(layer, {{{17, 20}, {43, 20}}, {{30, 7}, {30, 33}}});
  for (const sheet::Stroke& stroke : layer.strokes) {
    // An odd number of dashes: the middle is a dash, not a dot.
    const sheet::Dashes& d = stroke.dashes;
    const double period = d.dash + 2 * d.gap + d.dot, dashes = (26 - d.dash) / period + 1;
    EXPECT_NEAR(std::remainder(dashes - 1, 2), 0, 1e-9) << dashes;
    EXPECT_GT(d.dash, 0);
  }
}

TEST(CentreLines, OfConcentricCirclesTheLargestCounts) {
  expect_spans(lines(top, {circle({30, 20, 5}, {0, 0, 1}, 4), circle({30, 20, 0}, {0, 0, -1}, 10)}),
               {{{17, 20}, {43, 20}}, {{30, 7}, {30, 33}}});
}

TEST(CentreLines, OfShortLinesAreContinuous) {
  for (const sheet::Stroke& stroke : lines(top, {circle({0, 0, 0}, {0, 0, 1}, 2)}).strokes)
    EXPECT_EQ(stroke.dashes.dash, 0);
}

TEST(CentreLines, OfAShaftSeenFromTheSideAreItsAxis) {
  expect_spans(lines(front, {circle({0, 0, 10}, {1, 0, 0}, 5), circle({40, 0, 10}, {-1, 0, 0}, 5),
                             circle({60, 7, 10}, {1, 0, 0}, 9)}),
               {{{-3, 10}, {63, 10}}});
}

TEST(CentreLines, OneCircleEdgeOnHasAnAxis) {
  expect_spans(lines(front, {circle({0, 0, 10}, {0, 0, 1}, 5)}), {{{0, 7}, {0, 13}}});
}

TEST(CentreLines, ObliqueCirclesHaveAnAxisWhenThereAreTwo) {
  const double root = std::sqrt(0.5);
  const drawing::ViewDrawing slanted = view({1, 0, 0}, {0, root, root});
  EXPECT_TRUE(lines(slanted, {circle({0, 0, 0}, {0, 0, 1}, 10)}).strokes.empty());
  // Seen at 45 degrees, circles reach 10 sqrt(1/2) along the image of their axis.
  expect_spans(lines(slanted, {circle({0, 0, 0}, {0, 0, 1}, 10), circle({0, 0, 20}, {0, 0, 1}, 10)}),
               {{{0, -10 * root - 3}, {0, 30 * root + 3}}});
}

TEST(CentreLines, AnApexIsAnEndOfTheAxis) {
  const Round cone{0, {0, 0, -1}, {{{5, 0, 20}, 0}, {{5, 0, 0}, 10}}, {}};
  expect_spans(lines(front, {cone}), {{{5, -3}, {5, 23}}});
  expect_spans(lines(top, {cone}), {{{-8, 0}, {18, 0}}, {{5, -13}, {5, 13}}});
}

TEST(CentreLines, FeaturesBehindEachOtherHaveTheirOwn) {
  // Two holes on one line of the paper, their axes inclined to it: a line through both would be the axis of neither.
  const double root = std::sqrt(0.5);
  const Round low{0, {0, 0, 1}, {{{0, 0, 0}, 5}, {{0, 0, 10}, 5}}, {}};
  const Round high{0, {0, 0, 1}, {{{0, 80, 0}, 5}, {{0, 80, 10}, 5}}, {}};
  expect_spans(lines(view({1, 0, 0}, {0, root, root}), {low, high}),
               {{{0, -5 * root - 3}, {0, 15 * root + 3}}, {{0, 75 * root - 3}, {0, 95 * root + 3}}});
}

TEST(CentreLines, OverlappingOnesAreOneLine) {
  // Two holes in a row, and the axis of a third one behind them.
  expect_spans(lines(top, {circle({0, 0, 0}, {0, 0, 1}, 5), circle({12, 0, 0}, {0, 0, 1}, 5),
                           circle({40, 0, -9}, {1, 0, 0}, 5), circle({14, 0, -9}, {1, 0, 0}, 5)}),
               {{{-8, 0}, {43, 0}}, {{0, -8}, {0, 8}}, {{12, -8}, {12, 8}}});
}

// A dash is in the middle of a line through one circle, but not of one through several.
TEST(CentreLines, OverlappingOnesHaveNoDashInTheMiddleUnlessItIsThatOfAll) {
  bool any = false;
  for (double apart = 6; apart < 18; ++apart) {
    const sheet::Layer layer = lines(top, {circle({0, 0, 0}, {0, 0, 1}, 10), circle({apart, 0, 0}, {0, 0, 1}, 7)});
    ASSERT_EQ(layer.strokes.size(), 3U);
    const double length = std::max(13.0, apart + 10) + 13;
    const sheet::Dashes open = sheet::fit_open(length, 0.25, scene::long_dash_dot);
    any = any || open != sheet::fit_centred(length, 0.25, scene::long_dash_dot);
    for (const sheet::Stroke& stroke : layer.strokes)
      if (stroke.points[0].y == stroke.points[1].y) {
        EXPECT_EQ(stroke.dashes, open) << apart;
      }
  }
  EXPECT_TRUE(any);
}

TEST(CentreLines, RemainsOfLessThanAMillimetreAreNotDrawn) {
  for (const double left : {0.9, 1.1}) {
    const sheet::Stroke edge{{{0, 20}, {43 - left, 20}}};
    const std::vector<sheet::Layer> drawn{{"front/visible", {"visible", 0.5}, {edge}}};
    EXPECT_EQ(lines(top, {circle({30, 20, 5}, {0, 0, 1}, 10)}, drawn).strokes.size(), left < 1 ? 1U : 2U);
  }
}

TEST(CentreLines, OtherLinesWin) {
  const sheet::Stroke edge{{{10, 20.01}, {35, 20}}};
  const sheet::Stroke crossing{{{40, 0}, {40, 40}}};
  const std::vector<sheet::Layer> drawn{{"front/visible", {"visible", 0.5}, {edge, crossing}}};
  expect_spans(lines(top, {circle({30, 20, 5}, {0, 0, 1}, 10)}, drawn), {{{30, 7}, {30, 33}}, {{35, 20}, {43, 20}}});
}

TEST(CentreLines, CentralProjectionsHaveNone) {
  drawing::ViewDrawing central = top;
  central.projection.central = true;
  EXPECT_TRUE(lines(central, {circle({30, 20, 5}, {0, 0, 1}, 10)}).strokes.empty());
}

TEST(CentreLines, WithoutHiddenLinesOnlyWhatIsSeenHasThem) {
  drawing::ViewDrawing drawing = top;
  drawing.segments.push_back({{0, 0}, {1, 1}, true, EdgeKind::crease, 0, {7, 4}, -1, {0, 1}});
  drawing.segments.push_back({{0, 0}, {1, 1}, false, EdgeKind::crease, 0, {20, 21}, -1, {0, 1}});
  const features::CentredFeatures features{
      {circle({0, 0, 0}, {0, 0, 1}, 10, {4, 5, 6, 7}), circle({50, 0, 0}, {0, 0, 1}, 10, {20, 21, 22, 23})},
      {},
      {},
      {}};
  EXPECT_EQ(lines(drawing, features, {}, HiddenLines::none).strokes.size(), 2U);
  EXPECT_EQ(lines(drawing, features, {}, HiddenLines::dashed).strokes.size(), 4U);
}

TEST(CentreLines, WithoutHiddenLinesBoresAreNotSeenFromTheSide) {
  // Their rims are seen as lines of the outline.
  drawing::ViewDrawing drawing = front;
  drawing.segments.push_back({{0, 0}, {1, 0}, true, EdgeKind::crease, 0, {4, 5}, -1, {0, 1}});
  Round bore{0, {0, 0, 1}, {{{0, 0, 0}, 10}, {{0, 0, 8}, 10}}, {4, 5, 6, 7}, true};
  EXPECT_TRUE(lines(drawing, features::CentredFeatures{{bore}, {}, {}, {}}, {}, HiddenLines::none).strokes.empty());
  EXPECT_EQ(lines(drawing, features::CentredFeatures{{bore}, {}, {}, {}}).strokes.size(), 1U);
  drawing.world_to_page = top.world_to_page;
  EXPECT_EQ(lines(drawing, features::CentredFeatures{{bore}, {}, {}, {}}, {}, HiddenLines::none).strokes.size(), 2U);
  bore.enclosed = false;
  drawing.world_to_page = front.world_to_page;
  EXPECT_EQ(lines(drawing, features::CentredFeatures{{bore}, {}, {}, {}}, {}, HiddenLines::none).strokes.size(), 1U);
}

// The part of a circle about the z axis that is seen, from `first` to `last` of 72 chords, and the rest hidden.
void add_rim(drawing::ViewDrawing& drawing, const features::Ring& ring, int first_vertex, int first, int last) {
  const auto place = [&](int i) {
    const double angle = i * std::numbers::pi / 36;
    return Vec2(drawing.world_to_page * Vec4(ring.centre + ring.radius * Vec3(std::cos(angle), std::sin(angle), 0), 1));
  };
  for (int i = 0; i < 72; ++i)
    drawing.segments.push_back({place(i),
                                place(i + 1),
                                i >= first && i < last,
                                EdgeKind::crease,
                                0,
                                {first_vertex + i, first_vertex + (i + 1) % 72},
                                -1,
                                {0, 1}});
}

TEST(CentreLines, WithoutHiddenLinesAxesOfBoresPassThroughVisibleRims) {
  const double root = std::sqrt(0.5), reach = 10 * root + 3;
  Round bore{0, {0, 0, 1}, {{{0, 0, 0}, 10}, {{0, 0, 40}, 10}}, {}, true};
  for (int v = 0; v < 144; ++v) bore.vertices.push_back(v);
  const auto lines_of = [&](int below, int above, HiddenLines hidden) {
    drawing::ViewDrawing slanted = view({1, 0, 0}, {0, root, root});
    add_rim(slanted, bore.rings[0], 0, 0, below);
    add_rim(slanted, bore.rings[1], 72, 0, above);
    return lines(slanted, features::CentredFeatures{{bore}, {}, {}, {}}, {}, hidden);
  };
  const Vec2 top_centre(0, 40 * root), axis(0, reach);
  expect_spans(lines_of(0, 72, HiddenLines::none), {{top_centre - axis, top_centre + axis}});
  // Of half a rim, the half above its centre: up to 3 mm beyond what is seen.
  expect_spans(lines_of(17, 36, HiddenLines::none), {{top_centre - Vec2(0, 3), top_centre + axis}});
  expect_spans(lines_of(0, 72, HiddenLines::dashed), {{-axis, top_centre + axis}});
  expect_spans(lines_of(72, 72, HiddenLines::none), {{-axis, axis}, {top_centre - axis, top_centre + axis}});
  EXPECT_TRUE(lines_of(0, 17, HiddenLines::none).strokes.empty());
}

TEST(CentreLines, WithoutHiddenLinesAxesOfShaftsLieWhereBothSidesAreSeen) {
  const double root = std::sqrt(0.5), reach = 10 * root + 3;
  Round shaft{0, {0, 0, 1}, {{{0, 0, 0}, 10}, {{0, 0, 100}, 10}}, {}};
  for (int v = 0; v < 144; ++v) shaft.vertices.push_back(v);
  // Its upper rim is seen or not, and its contours at x = 10 and -10 up to a height on paper.
  const auto lines_of = [&](bool rim, std::array<double, 2> right, std::array<double, 2> left, HiddenLines hidden) {
    drawing::ViewDrawing slanted = view({1, 0, 0}, {0, root, root});
    add_rim(slanted, shaft.rings[0], 0, 0, 0);
    add_rim(slanted, shaft.rings[1], 72, 0, rim ? 72 : 0);
    for (const auto& [x, ends, vertex] : {std::tuple(10.0, right, 0), std::tuple(-10.0, left, 36)})
      slanted.segments.push_back(
          {{x, ends[0]}, {x, ends[1]}, true, EdgeKind::contour, 0, {vertex, vertex + 72}, -1, {0, 1}});
    return lines(slanted, features::CentredFeatures{{shaft}, {}, {}, {}}, {}, hidden);
  };
  const double upper = 100 * root;
  expect_spans(lines_of(true, {50, upper}, {40, upper}, HiddenLines::none), {{{0, 47}, {0, upper + reach}}});
  expect_spans(lines_of(true, {50, upper}, {40, upper}, HiddenLines::dashed), {{{0, -reach}, {0, upper + reach}}});
  expect_spans(lines_of(false, {10, 20}, {10, 40}, HiddenLines::none), {{{0, 7}, {0, 23}}});
  expect_spans(lines_of(true, {10, 20}, {0, 25}, HiddenLines::none),
               {{{0, 7}, {0, 23}}, {{0, upper - reach}, {0, upper + reach}}});
  // Something covers one side of its middle only.
  expect_spans(lines_of(true, {0, 25}, {0, upper}, HiddenLines::none), {{{0, -3}, {0, upper + reach}}});
  // Something covers its left half, and with it the axis.
  EXPECT_TRUE(lines_of(false, {10, 20}, {40, 50}, HiddenLines::none).strokes.empty());
  shaft.cut = true;  // lines of a section are not among its own
  expect_spans(lines_of(true, {50, upper}, {40, upper}, HiddenLines::none), {{{0, -reach}, {0, upper + reach}}});
}

TEST(CentreLines, WithoutHiddenLinesAShaftFromTheSideIsSeenByOneContour) {
  Round shaft{0, {0, 0, 1}, {{{0, 0, 0}, 10}, {{0, 0, 100}, 10}}, {1, 2}};
  drawing::ViewDrawing drawing = front;
  drawing.segments.push_back({{10, 30}, {10, 100}, true, EdgeKind::contour, 0, {1, 2}, -1, {0, 1}});
  expect_spans(lines(drawing, features::CentredFeatures{{shaft}, {}, {}, {}}, {}, HiddenLines::none),
               {{{0, 27}, {0, 103}}});
}

TEST(CentreLines, SmallOnesAreLeftOut) {
  EXPECT_TRUE(lines(top, {circle({0, 0, 0}, {0, 0, 1}, 1.49)}).strokes.empty());
  EXPECT_TRUE(lines(front, {circle({0, 0, 0}, {0, 0, 1}, 1.49)}).strokes.empty());
  EXPECT_EQ(lines(top, {circle({0, 0, 0}, {0, 0, 1}, 1.51)}).strokes.size(), 2U);
}

TEST(CentreLines, OfASlotAreOneAlongItAndOneAtEachEnd) {
  const auto end = [](double x, double y) { return Round{0, {0, 0, 1}, {{{x, y, 0}, 5}, {{x, y, 12}, 5}}, {}}; };
  const features::CentredFeatures slot{{}, {{{end(10, 0), end(40, 0)}}}, {}, {}};
  expect_spans(lines(top, slot), {{{2, 0}, {48, 0}}, {{10, -8}, {10, 8}}, {{40, -8}, {40, 8}}});
  // From the side it has one axis, in its middle; across and along it.
  expect_spans(lines(front, slot), {{{25, -3}, {25, 15}}});
  expect_spans(lines(view({0, 1, 0}, {0, 0, 1}), slot), {{{0, -3}, {0, 15}}});
  // A slanted one: 30, 40, 50.
  const features::CentredFeatures slanted{{}, {{{end(0, 0), end(30, 40)}}}, {}, {}};
  expect_spans(lines(top, slanted),
               {{{-6.4, 4.8}, {6.4, -4.8}}, {{-4.8, -6.4}, {34.8, 46.4}}, {{23.6, 44.8}, {36.4, 35.2}}});
}

// By these alone it is seen that they are on a circle.
TEST(CentreLines, OfSmallHolesAreDrawnOnAPitchCircle) {
  std::vector<Round> round;
  for (const Vec2& at : {Vec2(24, 32), Vec2(-32, 24), Vec2(-24, -32)})
    round.push_back(circle({at, 0}, {0, 0, -1}, 0.6));
  EXPECT_TRUE(lines(top, round).strokes.empty());
  const features::CentredFeatures on_circle{round, {}, {}, {{{0, 0, -7}, {0, 0, 1}, 40, {0, 1, 2}}}};
  EXPECT_EQ(lines(top, on_circle).strokes.size(), 4U) << "a mark for each, and the circle";
  EXPECT_TRUE(lines(front, on_circle).strokes.empty());
}

TEST(CentreLines, OfHolesOnAPitchCircleAreThatAndMarksAlongRadii) {
  std::vector<Round> round{circle({0, 0, 0}, {0, 0, 1}, 10)};
  for (const Vec2& at : {Vec2(24, 32), Vec2(-32, 24), Vec2(-24, -32)}) round.push_back(circle({at, 0}, {0, 0, -1}, 4));
  const features::CentredFeatures features{round, {}, {}, {{{0, 0, -7}, {0, 0, 1}, 40, {1, 2, 3}}}};
  sheet::Layer layer = lines(top, features);
  ASSERT_EQ(layer.strokes.size(), 6U);
  const sheet::Stroke circle = layer.strokes.back();
  EXPECT_TRUE(circle.closed);
  ASSERT_EQ(circle.curves.size(), 1U);
  EXPECT_EQ(circle.curves[0].last, static_cast<int>(circle.points.size()));
  for (const Vec2& p : circle.points) EXPECT_NEAR(glm::length(p), 40, 1e-9);
  const double periods = 2 * std::acos(-1.0) * 40 / (circle.dashes.dash + circle.dashes.dot + 2 * circle.dashes.gap);
  EXPECT_NEAR(periods, std::round(periods), 1e-9);
  layer.strokes.pop_back();
  // Along (0.6, 0.8) by 4 + 3 on either side of the hole.
  expect_spans(layer, {{{-37.6, 28.2}, {-26.4, 19.8}},
                       {{-28.2, -37.6}, {-19.8, -26.4}},
                       {{-13, 0}, {13, 0}},
                       {{0, -13}, {0, 13}},
                       {{19.8, 26.4}, {28.2, 37.6}}});
  // From the side they have their axes.
  EXPECT_EQ(lines(front, features).strokes.size(), 4U);
}

TEST(CentreLines, OfATurnedPartAreAlongItsOwnAxes) {
  Round turned = circle({0, 0, 0}, {0, 0, 1}, 10);
  turned.beside = {0.6, 0.8, 0};
  expect_spans(lines(top, std::vector<Round>{turned}), {{{-10.4, 7.8}, {10.4, -7.8}}, {{-7.8, -10.4}, {7.8, 10.4}}});
}

// From axis to axis, not beyond the crosses of the bosses; nothing where the axes are seen as lines.
TEST(CentreLines, AnArmHasOneFromAxisToAxis) {
  const std::vector<features::CentredRound> bosses{circle({0, 0, 0}, {0, 0, 1}, 10, {0}),
                                                   circle({30, 40, 0}, {0, 0, 1}, 10, {1})};
  const features::CentredFeatures with{bosses, {}, {{{0, 1}, 6}}, {}}, without{bosses, {}, {}, {}};
  const sheet::Layer layer = lines(top, with);
  ASSERT_EQ(layer.strokes.size(), lines(top, without).strokes.size() + 1);
  EXPECT_TRUE(std::ranges::any_of(layer.strokes, [](const sheet::Stroke& stroke) {
    return std::abs(glm::distance(stroke.points.front(), stroke.points.back()) - 50) < 1e-9;
  }));
  EXPECT_EQ(lines(front, with).strokes.size(), lines(front, without).strokes.size());
}

}  // namespace
}  // namespace epura::centre_lines_test
