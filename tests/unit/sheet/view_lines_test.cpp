// SPDX-License-Identifier: Apache-2.0
#include "sheet/view_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "sheet/dash.hpp"

namespace epura::view_lines_test {
namespace {

sheet::BodyStyles all_bodies(HiddenLines hidden) { return {{{{LineRole::visible, hidden, {}, {}}}}}; }

void add_chain(drawing::ViewDrawing& drawing, const std::vector<Vec2>& points, bool closed, bool visible) {
  drawing::Chain chain{points, closed, visible, EdgeKind::crease, {}};
  const std::size_t lines = points.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < lines; ++i) {
    const int number = static_cast<int>(drawing.segments.size());
    chain.segments.push_back(number);
    drawing.segments.push_back(
        {points[i], points[(i + 1) % points.size()], visible, EdgeKind::crease, 0, {number + 1, number}, -1, {0, 1}});
  }
  drawing.chains.push_back(chain);
}

drawing::ViewDrawing example() {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  add_chain(drawing, {{10, 10}, {50, 10}, {50, 40}}, true, true);
  add_chain(drawing, {{10, 10}, {30, 20}}, false, true);
  add_chain(drawing, {{20, 20}, {60, 20}, {60, 50}}, false, false);
  add_chain(drawing, {{20, 20}, {22, 20}, {22, 22}}, false, false);
  return drawing;
}

TEST(ViewLines, HiddenLinesLieUnderVisibleOnes) {
  const std::vector<sheet::Layer> layers = sheet::view_layers(example(), {0.5, 0.25}, all_bodies(HiddenLines::dashed));
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].name, "front/hidden");
  EXPECT_EQ(layers[0].style.width, 0.25);
  EXPECT_EQ(layers[0].style.dashes.dash, 3);
  EXPECT_EQ(layers[0].style.dashes.gap, 0.75);
  EXPECT_EQ(layers[1].name, "front/visible");
  EXPECT_EQ(layers[1].style.width, 0.5);
  EXPECT_EQ(layers[1].style.dashes.dash, 0);
  ASSERT_EQ(layers[1].strokes.size(), 2u);
  EXPECT_TRUE(layers[1].strokes[0].closed);
}

TEST(LineRoles, HaveNamesThatAreFoundAndWordsOfModels) {
  std::set<std::string_view> names, layers;
  for (const scene::SheetLineRow& row : scene::sheet_lines) {
    EXPECT_TRUE(names.insert(row.name).second && layers.insert(row.layer).second) << row.name;
    EXPECT_EQ(scene::find_line(row.name), &row);
    EXPECT_EQ(scene::find_line(row.layer), &row);
  }
  EXPECT_EQ(scene::find_line("front/visible"), nullptr);
  const std::vector<std::string> words(scene::Words<LineRole>::list.begin(), scene::Words<LineRole>::list.end());
  EXPECT_EQ(words, (std::vector<std::string>{"visible", "narrow", "neighbour", "wide"}));
  EXPECT_EQ(scene::word_of(LineRole::neighbour), "neighbour");
}

TEST(ViewLines, LargeSheetsHaveWiderLines) {
  for (const char* size : {"A0", "A1"}) {
    EXPECT_EQ(sheet::line_widths(sheet::make_paper(scene::parse_paper_size(size, "--sheet"), true)).wide, 0.7);
    EXPECT_EQ(sheet::line_widths(sheet::make_paper(scene::parse_paper_size(size, "--sheet"), true)).narrow, 0.35);
  }
  EXPECT_EQ(sheet::line_widths(sheet::make_paper(scene::parse_paper_size("A2", "--sheet"), false)).wide, 0.5);
}

TEST(ViewLines, DashedLinesAreCutAtCorners) {
  const std::vector<sheet::Layer> layers = sheet::view_layers(example(), {0.5, 0.25}, all_bodies(HiddenLines::dashed));
  const std::vector<sheet::Stroke>& strokes = layers[0].strokes;
  ASSERT_EQ(strokes.size(), 3u);
  EXPECT_EQ(strokes[0].points, (std::vector<Vec2>{{20, 20}, {60, 20}}));
  EXPECT_EQ(strokes[1].points, (std::vector<Vec2>{{60, 20}, {60, 50}}));
  for (int i : {0, 1}) {
    const sheet::Stroke& stroke = strokes[i];
    const double gaps =
        (sheet::length_of(stroke.points, false) - stroke.dashes.dash) / (stroke.dashes.dash + stroke.dashes.gap);
    EXPECT_NEAR(gaps, std::round(gaps), 1e-9);
    EXPECT_GT(stroke.dashes.dash, 2);
  }
  // Each piece names its own edges only.
  EXPECT_EQ(strokes[0].edges, (std::vector<sheet::ModelEdge>{{0, {4, 5}}}));
  EXPECT_EQ(strokes[1].edges, (std::vector<sheet::ModelEdge>{{0, {5, 6}}}));
  EXPECT_EQ(strokes[0].kind, EdgeKind::crease);
  EXPECT_NEAR(strokes[2].dashes.dash, 1.625, 1e-12) << "two short dashes and a gap in 4 mm";
  EXPECT_EQ(strokes[2].edges, (std::vector<sheet::ModelEdge>{{0, {6, 7}}, {0, {7, 8}}}));
}

TEST(ViewLines, HiddenLinesAsWished) {
  const std::vector<sheet::Layer> none = sheet::view_layers(example(), {0.5, 0.25}, all_bodies(HiddenLines::none));
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].name, "front/visible");
  const std::vector<sheet::Layer> solid = sheet::view_layers(example(), {0.5, 0.25}, all_bodies(HiddenLines::solid));
  EXPECT_EQ(solid[0].style.dashes.dash, 0);
  EXPECT_EQ(solid[0].style.width, 0.25);
  ASSERT_EQ(solid[0].strokes.size(), 2u);
  EXPECT_EQ(solid[0].strokes[0].points.size(), 3u);
}

// A hidden line through a field of others, `apart` mm from each other.
sheet::Stroke hidden_through_field(double apart) {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  add_chain(drawing, {{0, 0}, {100, 0}}, false, false);
  for (double x = apart; x < 100; x += apart) add_chain(drawing, {{x, -10}, {x, 10}}, false, true);
  return sheet::view_layers(drawing, {0.5, 0.25}, all_bodies(HiddenLines::dashed))[0].strokes[0];
}

// Whatever crosses it, a hidden line looks dashed.
TEST(ViewLines, CrossingsAreHeededWhereTheyLeaveRoomForGaps) {
  EXPECT_NE(hidden_through_field(10.6).dashes, sheet::fit_open(100, 0.25));
  for (const double apart : {1.0, 0.5, 0.2, 0.1}) {
    const sheet::Stroke stroke = hidden_through_field(apart);
    EXPECT_TRUE(stroke.pattern.empty());
    EXPECT_EQ(stroke.dashes, sheet::fit_open(100, 0.25)) << apart;
  }
}

TEST(ViewLines, IntersectionLinesNameNoEdge) {
  drawing::ViewDrawing drawing = example();
  drawing.segments[0].edge = {-1, -1};
  drawing.segments[2].edge = drawing.segments[1].edge;
  const std::vector<sheet::Layer> layers = sheet::view_layers(drawing, {0.5, 0.25}, all_bodies(HiddenLines::dashed));
  EXPECT_EQ(layers[1].strokes[0].edges, (std::vector<sheet::ModelEdge>{{0, {1, 2}}}));
}

TEST(ViewLines, ModelsHaveLooksOfTheirOwn) {
  drawing::ViewDrawing drawing = example();
  for (const int segment : drawing.chains[1].segments) drawing.segments[segment].model = 1;
  for (const int segment : drawing.chains[2].segments) drawing.segments[segment].model = 1;
  const sheet::BodyStyle usual{LineRole::visible, HiddenLines::dashed}, other{LineRole::neighbour, HiddenLines::none};
  const std::vector<sheet::Layer> layers =
      sheet::view_layers(drawing, {0.5, 0.25}, sheet::BodyStyles{{{usual}, {other}}});
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[0].strokes.size(), 1u);  // the hidden line of the other model is left out
  EXPECT_EQ(layers[1].name, "front/neighbour");
  EXPECT_EQ(layers[1].style.dashes, sheet::nominal_dashes(scene::long_dash_double_dot, 0.25));
  EXPECT_EQ(layers[1].strokes[0].dashes.dots, 2);
  EXPECT_EQ(layers[2].strokes.size(), 1u);
}

TEST(ViewLines, TangentEdgesAreNarrowAndShortOfOutlines) {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  add_chain(drawing, {{0, 0}, {50, 0}}, false, true);
  add_chain(drawing, {{10, 0}, {10, 20}}, false, true);
  drawing.chains[1].kind = EdgeKind::smooth;
  add_chain(drawing, {{20, 0}, {20, 20}}, false, false);
  drawing.chains[2].kind = EdgeKind::smooth;
  const std::vector<sheet::Layer> layers = sheet::view_layers(drawing, {0.5, 0.25}, all_bodies(HiddenLines::dashed));
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_TRUE(layers[0].strokes.empty());
  EXPECT_EQ(layers[1].name, "front/tangent");
  EXPECT_EQ(layers[1].style.width, 0.25);
  EXPECT_EQ(layers[1].strokes[0].points, (std::vector<Vec2>{{10, 1}, {10, 20}}));
}

constexpr double step = std::numbers::pi / 6;
const drawing::CurvePart quarter{0, 3, {0, 60}, {60, 0}, {0, 60}, -3 * step, 0};

Vec2 on(const drawing::CurvePart& curve, double angle) {
  return curve.centre + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
}

// Tangent edges that are arcs end short of outlines at both ends.
TEST(ViewLines, ShortenedArcsRunFromPointToPoint) {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  std::vector<Vec2> points;
  for (int i = 0; i <= 3; ++i) points.push_back(on(quarter, quarter.from + i * step));
  add_chain(drawing, points, false, true);
  drawing.chains[0].kind = EdgeKind::smooth;
  drawing.chains[0].curves = {quarter};
  add_chain(drawing, {points[0] - Vec2(0, 9), points[0] + Vec2(0, 9)}, false, true);
  const std::vector<sheet::Layer> layers = sheet::view_layers(drawing, {0.5, 0.25}, all_bodies(HiddenLines::dashed));
  const auto tangent = std::find_if(layers.begin(), layers.end(),
                                    [](const sheet::Layer& layer) { return layer.name == "front/tangent"; });
  ASSERT_NE(tangent, layers.end());
  const sheet::Stroke& stroke = tangent->strokes.at(0);
  ASSERT_EQ(stroke.curves.size(), 1U);
  const drawing::CurvePart& curve = stroke.curves[0];
  EXPECT_EQ(curve.first, 1);
  EXPECT_EQ(curve.last, 3);
  EXPECT_LT(glm::distance(on(curve, curve.from), stroke.points.at(1)), 1e-9);
  EXPECT_LT(glm::distance(on(curve, curve.to), stroke.points.at(3)), 1e-9);
}

// Whether there is ink at a distance from the beginning of a line.
bool has_ink(const sheet::Stroke& stroke, double place) {
  if (stroke.pattern.empty())
    return std::fmod(place, stroke.dashes.dash + stroke.dashes.gap) <= stroke.dashes.dash + 1e-9;
  std::size_t i = 0;
  for (double end = stroke.pattern[0]; i + 1 < stroke.pattern.size() && end < place - 1e-9; end += stroke.pattern[i])
    ++i;
  return i % 2 == 0;
}

// Behind an arc, places along the line are not those along its chords.
TEST(ViewLines, CrossingsBehindAnArcHaveInk) {
  const double length = 60 * 3 * step;
  for (double place = 15; place < 55; place += 0.5) {
    drawing::ViewDrawing drawing;
    drawing.name = "front";
    std::vector<Vec2> points;
    for (int i = 0; i <= 3; ++i) points.push_back(on(quarter, quarter.from + i * step));
    points.emplace_back(60, 120);
    add_chain(drawing, points, false, false);
    drawing.chains[0].curves = {quarter};
    add_chain(drawing, {{50, 60 + place}, {70, 60 + place}}, false, true);
    const std::vector<sheet::Layer> layers = sheet::view_layers(drawing, {0.5, 0.25}, all_bodies(HiddenLines::dashed));
    const sheet::Stroke& stroke = layers.at(0).strokes.at(0);
    ASSERT_EQ(stroke.points.size(), 5U);
    EXPECT_TRUE(has_ink(stroke, length + place)) << place;
  }
}

TEST(ViewLayers, OfBodiesWithAColourOrALayerOfTheirOwn) {
  drawing::ViewDrawing drawing = example();
  for (drawing::Segment& segment : drawing.segments) segment.body = 0;
  for (const int s : drawing.chains[1].segments) drawing.segments[static_cast<std::size_t>(s)].body = 1;
  for (const int s : drawing.chains[2].segments) drawing.segments[static_cast<std::size_t>(s)].body = 2;
  const sheet::BodyStyle usual;
  const sheet::BodyStyle red{LineRole::visible, HiddenLines::dashed, {204, 0, 0}, {}};
  const sheet::BodyStyle bolt{LineRole::narrow, HiddenLines::solid, {}, {}, "bolt"};
  const std::vector<sheet::Layer> layers = sheet::view_layers(drawing, {0.5, 0.25}, {{{usual, red, bolt}}});
  std::vector<std::string> names;
  for (const sheet::Layer& layer : layers) names.push_back(layer.name);
  EXPECT_EQ(names, (std::vector<std::string>{"front/hidden", "front/hidden-solid", "front/hidden-solid bolt",
                                             "front/visible", "front/visible #cc0000"}));
  EXPECT_EQ(layers[0].strokes.size(), 1U);
  EXPECT_EQ(layers[2].strokes.size(), 1U);
  EXPECT_EQ(layers[4].strokes.size(), 1U);
  EXPECT_EQ(layers[4].style.colour, (Colour{204, 0, 0}));
  EXPECT_EQ(layers[4].style.name, "visible");
}

}  // namespace
}  // namespace epura::view_lines_test
