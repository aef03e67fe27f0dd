// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "dxf_reader.hpp"
#include "output/dxf_writer.hpp"
#include "output/write.hpp"
#include "rasters.hpp"
#include "support.hpp"

namespace epura::dxf_test {
namespace {

constexpr double pi = std::numbers::pi;

class DxfOfSize : public testing::TestWithParam<Vec2> {};

TEST_P(DxfOfSize, KeepsEveryBitOfCoordinates) {
  const sheet::Sheet sheet = random_sheet(GetParam().x, GetParam().y);
  const std::string dxf = output::to_dxf(sheet);
  EXPECT_EQ(largest_error(sheet.layers[0].strokes, ink_of(entities_of(dxf, "a view-hidden"))), 0);
  EXPECT_EQ(largest_error(sheet.layers[1].strokes, ink_of(entities_of(dxf, "a view-visible"))), 0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, DxfOfSize,
                         testing::Values(Vec2(297, 210), Vec2(1189, 841), Vec2(123.4567, 33.3333), Vec2(20000, 20000)));

sheet::Sheet one_stroke(const sheet::Stroke& stroke) {
  sheet::Sheet sheet{200, 200, "", {{"v/visible", {"visible", 0.5}, {}}}};
  sheet.layers[0].strokes.push_back(stroke);
  return sheet;
}

Vec2 on(const drawing::CurvePart& curve, double angle) {
  return curve.centre + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
}

// Points along the curve, as many as the part says.
std::vector<Vec2> corners_of(const drawing::CurvePart& curve) {
  std::vector<Vec2> points;
  for (int i = curve.first; i <= curve.last; ++i)
    points.push_back(on(curve, curve.from + (curve.to - curve.from) * (i - curve.first) / (curve.last - curve.first)));
  return points;
}

TEST(DxfCurves, AWholeCircleIsACircle) {
  const drawing::CurvePart curve{0, 24, {60, 70}, {0, 30}, {30, 0}, 1, 1 - 2 * pi};
  sheet::Stroke stroke{corners_of(curve), true, {}, {}, {}, {}, {curve}};
  stroke.points.pop_back();
  const auto entities = entities_of(output::to_dxf(one_stroke(stroke)), "v-visible");
  ASSERT_EQ(entities.size(), 1u);
  EXPECT_EQ(entities[0].type, "CIRCLE");
  EXPECT_EQ(entities[0].point(10), Vec2(60, 70));
  EXPECT_EQ(entities[0].number(40), 30);
}

TEST(DxfCurves, AnArcAloneRunsCounterclockwise) {
  const drawing::CurvePart curve{0, 12, {60, 70}, {30, 0}, {0, 30}, pi / 2, -pi / 4};
  const auto entities =
      entities_of(output::to_dxf(one_stroke({corners_of(curve), false, {}, {}, {}, {}, {curve}})), "v-visible");
  ASSERT_EQ(entities.size(), 1u);
  EXPECT_EQ(entities[0].type, "ARC");
  EXPECT_NEAR(entities[0].number(50), -45, 1e-12);
  EXPECT_NEAR(entities[0].number(51), 90, 1e-12);
}

// A point of an ELLIPSE at its parameter.
Vec2 on(const DxfRecord& ellipse, double parameter) {
  const Vec2 major = ellipse.point(11), minor = Vec2(-major.y, major.x) * ellipse.number(40);
  return ellipse.point(10) + std::cos(parameter) * major + std::sin(parameter) * minor;
}

TEST(DxfCurves, EllipsesOfAllDirectionsKeepTheirPlaces) {
  const Vec2 long_axis(24, 18), short_axis(-6, 8);
  for (const auto& [u, v] : {std::pair{long_axis, short_axis}, {short_axis, long_axis}, {long_axis, -short_axis}}) {
    for (const auto& [from, to] : {std::pair{0.5, 2.5}, {2.5, 0.5}, {-1.0, 4.0}}) {
      const drawing::CurvePart curve{0, 12, {90, 100}, u, v, from, to};
      const auto dxf = output::to_dxf(one_stroke({corners_of(curve), false, {}, {}, {}, {}, {curve}}));
      const auto entities = entities_of(dxf, "v-visible");
      ASSERT_EQ(entities.size(), 1u);
      const DxfRecord& ellipse = entities[0];
      EXPECT_EQ(ellipse.type, "ELLIPSE");
      EXPECT_LT(ellipse.number(40), 1);
      const double begin = ellipse.number(41), end = ellipse.number(42);
      EXPECT_NEAR(end - begin, std::abs(to - from), 1e-12);
      const bool forwards = glm::distance(on(ellipse, begin), on(curve, from)) < 1e-9;
      EXPECT_LT(glm::distance(on(ellipse, begin), on(curve, forwards ? from : to)), 1e-12);
      EXPECT_LT(glm::distance(on(ellipse, end), on(curve, forwards ? to : from)), 1e-12);
      EXPECT_LT(glm::distance(on(ellipse, (begin + end) / 2), on(curve, (from + to) / 2)), 1e-12);
    }
  }
}

// The middle of the arc that a bulge makes of the way from `a` to `b`.
Vec2 middle_of(const Vec2& a, const Vec2& b, double bulge) {
  const Vec2 half = (b - a) * 0.5;
  return a + half + Vec2(half.y, -half.x) * bulge;
}

// A regular polygon, or some of its corners.
sheet::Stroke polygon(double radius, int corners, int drawn) {
  sheet::Stroke stroke{{}, drawn == corners, {3, 0.75}};
  for (int i = 0; i < drawn; ++i)
    stroke.points.push_back(Vec2(90, 100) +
                            radius * Vec2(std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)));
  return stroke;
}

std::vector<DxfRecord> dashed_entities(const sheet::Stroke& stroke) {
  sheet::Sheet sheet = one_stroke(stroke);
  sheet.layers[0].style.dashes = {3, 0.75};
  return entities_of(output::to_dxf(sheet), "v-visible");
}

// LibreCAD begins dashes anew at each corner. What a polygon differs from its circle by is less than the line is wide.
TEST(DxfCurves, DashedCirclesOfShortPiecesAreCircles) {
  const auto circle = dashed_entities(polygon(40, 96, 96));
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_EQ(circle[0].type, "CIRCLE");
  EXPECT_LT(glm::distance(circle[0].point(10), Vec2(90, 100)), 1e-9);
  EXPECT_NEAR(circle[0].number(40), 40, 1e-9);
  const auto arc = dashed_entities(polygon(40, 96, 25));
  ASSERT_EQ(arc.size(), 1u);
  EXPECT_EQ(arc[0].type, "ARC");
  EXPECT_NEAR(arc[0].number(50), 0, 1e-9);
  EXPECT_NEAR(arc[0].number(51), 90, 1e-9);
  // The first polygon whose sides are nearer to the circle than a twentieth of a millimetre has 63.
  EXPECT_EQ(dashed_entities(polygon(40, 62, 62))[0].type, "LWPOLYLINE");
  EXPECT_EQ(dashed_entities(polygon(40, 63, 63))[0].type, "CIRCLE");
  EXPECT_EQ(entities_of(output::to_dxf(one_stroke(polygon(40, 96, 96))), "v-visible")[0].type, "LWPOLYLINE");
}

TEST(DxfCurves, DashedEllipsesOfShortPiecesAreArcs) {
  sheet::Stroke stroke = polygon(40, 360, 360);
  for (Vec2& p : stroke.points) p.y = 100 + (p.y - 100) / 2;
  const auto entities = dashed_entities(stroke);
  ASSERT_EQ(entities.size(), 1u);
  ASSERT_EQ(entities[0].type, "LWPOLYLINE");
  const std::vector<std::string> x = entities[0].all(10), y = entities[0].all(20), bulges = entities[0].all(42);
  EXPECT_LT(x.size(), 60u);
  ASSERT_EQ(bulges.size(), x.size());
  const auto off = [](const Vec2& p) {
    const Vec2 in = {(p.x - 90) / 40, (p.y - 100) / 20};
    return std::abs(glm::length(in) - 1) / glm::length(Vec2(in.x / 40, in.y / 20)) * glm::length(in);
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t next = (i + 1) % x.size();
    const Vec2 p(number_in(x[i]), number_in(y[i])), q(number_in(x[next]), number_in(y[next]));
    EXPECT_LT(off(p), 0.02);
    EXPECT_LT(off(middle_of(p, q, number_in(bulges[i]))), 0.05);
  }
}

TEST(DxfCurves, ArcsAmongLinesAreBulges) {
  // The outline of a slot: its arcs turn clockwise, the second one goes on past the first point.
  sheet::Stroke slot{{}, true};
  const drawing::CurvePart right{2, 14, {80, 50}, {20, 0}, {0, 20}, pi / 2, -pi / 2};
  slot.points = {{20, 70}, {50, 70}};
  for (const Vec2& p : corners_of(right)) slot.points.push_back(p);
  const drawing::CurvePart left{15, 27, {20, 50}, {20, 0}, {0, 20}, 1.5 * pi, pi / 2};
  for (const Vec2& p : corners_of(left)) slot.points.push_back(p);
  slot.points.pop_back();  // the first point
  slot.curves = {right, left};
  const auto entities = entities_of(output::to_dxf(one_stroke(slot)), "v-visible");
  ASSERT_EQ(entities.size(), 1u);
  EXPECT_EQ(entities[0].text(70), "1");
  EXPECT_EQ(entities[0].all(42).size(), 4u);  // quarters
  const std::vector<Vec2> corners = ink_of(entities)[0].points;
  ASSERT_EQ(corners.size(), 7u);
  std::size_t corner = 0;
  int arcs = 0;
  for (const auto& [code, value] : entities[0].groups) {
    if (code == 20) ++corner;
    if (code != 42) continue;
    const Vec2 middle = middle_of(corners[corner - 1], corners[corner % corners.size()], number_in(value));
    const Vec2 centre = middle.x > 50 ? right.centre : left.centre;
    EXPECT_NEAR(glm::distance(middle, centre), 20, 1e-12);
    EXPECT_GT(std::abs(middle.x - 50), 30);
    ++arcs;
  }
  EXPECT_EQ(arcs, 4);
}

TEST(DxfCurves, EllipsesCutPolylines) {
  const drawing::CurvePart curve{1, 13, {60, 50}, {30, 0}, {0, 10}, pi / 2, -pi / 2};
  sheet::Stroke stroke{{{20, 60}}, true, {}, {}, {}, {}, {curve}};
  for (const Vec2& p : corners_of(curve)) stroke.points.push_back(p);
  stroke.points.emplace_back(20, 40);
  const auto entities = entities_of(output::to_dxf(one_stroke(stroke)), "v-visible");
  ASSERT_EQ(entities.size(), 2u);
  EXPECT_EQ(entities[0].type, "ELLIPSE");
  EXPECT_EQ(entities[1].type, "LWPOLYLINE");
  const Ink rest = ink_of(entities)[1];
  EXPECT_FALSE(rest.closed);
  ASSERT_EQ(rest.points.size(), 4u);
  EXPECT_LT(glm::distance(rest.points.front(), Vec2(60, 40)), 1e-12);
  EXPECT_LT(glm::distance(rest.points.back(), Vec2(60, 60)), 1e-12);
}

TEST(DxfLayers, HaveLineTypesAndWidthsInMillimetres) {
  sheet::Sheet sheet = random_sheet(100, 100, 2);
  sheet.layers[0].strokes[1].dashes = {};
  sheet.layers.push_back({"v/cut", {"cut", 0.7, {16.8, 2.1, 0.35, 1}}, {}});
  sheet.layers.push_back({"v/centre", {"centre", 0.35, {8.4, 1.05, 0.175, 1}}, {}});
  const std::string dxf = output::to_dxf(sheet);
  const auto layers = table_of(dxf, "LAYER");
  ASSERT_EQ(layers.size(), 5u);
  EXPECT_EQ(layers[1].text(6), "DASHEDTINY");
  EXPECT_EQ(layers[1].text(370), "25");
  EXPECT_EQ(layers[2].text(6), "CONTINUOUS");
  EXPECT_EQ(layers[2].text(370), "50");
  EXPECT_EQ(layers[3].text(6), "DASHDOT2");
  EXPECT_EQ(layers[4].text(6), "DASHDOTTINY");
  for (const DxfRecord& type : table_of(dxf, "LTYPE")) {
    if (type.text(2) != "DASHDOTTINY") continue;
    EXPECT_EQ(type.all(49), (std::vector<std::string>{"8.4", "-1.05", "0.175", "-1.05"}));
    EXPECT_NEAR(type.number(40), 10.675, 1e-12);
  }
  const auto hidden = entities_of(dxf, "a view-hidden");
  EXPECT_EQ(hidden[0].text(6), "");
  EXPECT_EQ(hidden[1].text(6), "CONTINUOUS");
}

TEST(DxfTexts, CannotBreakOut) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  sheet.title = "a\n  0\nSECTION\r\n" + std::string(10000, 'x');
  sheet.layers[0].name = "<script>&\"'/b\n0\nLINE" + std::string(10000, 'y');
  sheet.layers[1].name = "<SCRIPT>&\"'/b\n0\nLINE" + std::string(10000, 'Y');
  sheet.layers[0].texts = {{"one\n0\nLINE\\P%%u 100 %^J \xC3\xB8 \xF0\x9F\x98\x80 \xFF", {5, 5}, 3.5}};
  const auto text_of = [&](output::DxfVersion version) {
    std::string text;
    for (const DxfRecord& record : dxf_records(output::to_dxf(sheet, {.dxf_version = version})))
      if (record.type == "TEXT") text += record.text(1);
    return text;
  };
  EXPECT_EQ(text_of(output::DxfVersion::r2007), "one 0 LINE\\P%%%%u 100 %^ J \xC3\xB8 \xF0\x9F\x98\x80 \xEF\xBF\xBD");
  EXPECT_EQ(text_of(output::DxfVersion::r2000), "one 0 LINE\\P%%%%u 100 %^ J \\U+00F8 \\U+FFFD \\U+FFFD");
  // An escape in the text is not one of the file.
  EXPECT_EQ(output::dxf_text("C:\\U+0041 \xC2\x85 \xE2\x80\xA8", output::DxfVersion::r2007), "C:\\U+005CU+0041    ");
  EXPECT_EQ(output::dxf_paragraph("{a}\\P \\U+0041", output::DxfVersion::r2007), "\\{a\\}\\\\P \\U+005CU+0041");
  const auto records = dxf_records(output::to_dxf(sheet));
  std::set<std::string> layers;
  int lines = 0, sections = 0;
  for (const DxfRecord& record : records) {
    lines += record.type == "LINE" ? 1 : 0;
    sections += record.type == "SECTION" ? 1 : 0;
    if (record.type == "LAYER") {
      EXPECT_TRUE(layers.insert(to_lower(record.text(2))).second);
      EXPECT_LT(record.text(2).size(), 256u);
      EXPECT_EQ(record.text(2).find_first_of("<>/\\\":;?*|=,'`"), std::string::npos);
    }
  }
  EXPECT_EQ(lines, 2);
  EXPECT_EQ(sections, 5);
}

TEST(DxfTexts, StandWhereTheyBelong) {
  sheet::Sheet sheet = random_sheet(100, 100, 0);
  sheet.layers[0].texts = {{"left", {5, 6}, 3.5}, {"right", {50, 60}, 7, 90, sheet::Align::right}};
  const auto texts = entities_of(output::to_dxf(sheet), "a view-hidden");
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(texts[0].point(10), Vec2(5, 6));
  EXPECT_EQ(texts[0].number(40), 3.5);
  EXPECT_EQ(texts[0].text(72), "0");
  EXPECT_EQ(texts[1].point(11), Vec2(50, 60));
  EXPECT_EQ(texts[1].number(50), 90);
  EXPECT_EQ(texts[1].text(72), "2");
}

TEST(DxfNames, AreCleanAndDifferent) {
  const std::vector<std::string> names = {"a/b", "A-B", "0", "", "  ", "\xC3\xA9"};
  EXPECT_EQ(output::dxf_names(names, {"0"}, output::DxfVersion::r2000),
            (std::vector<std::string>{"a-b", "A-B-2", "0-2", "layer", "layer-2", "\\U+00E9"}));
  EXPECT_EQ(output::dxf_names(names, {"0"}, output::DxfVersion::r2007).back(), "\xC3\xA9");
}

// LibreCAD prints on paper of $PLIMMAX, without which it takes A4.
TEST(Dxf, StatesTheSizeOfThePaper) {
  const std::string dxf = output::to_dxf(random_sheet(420, 297));
  for (const char* name : {"$EXTMAX", "$LIMMAX", "$PLIMMAX"})
    EXPECT_NE(dxf.find(std::string("\n") + name + "\n10\n420\n20\n297\n"), std::string::npos) << name;
}

TEST(Dxf, StatesTheVersionOfItsTexts) {
  const sheet::Sheet sheet = random_sheet(100, 100, 1);
  EXPECT_NE(output::to_dxf(sheet).find("\n$ACADVER\n1\nAC1021\n"), std::string::npos);
  EXPECT_NE(output::to_dxf(sheet, {.dxf_version = output::DxfVersion::r2000}).find("\n$ACADVER\n1\nAC1015\n"),
            std::string::npos);
}

// Ends of lines, and those of arcs as a program computes them from the file.
std::vector<std::array<Vec2, 2>> ends_of(const std::vector<DxfRecord>& entities) {
  std::vector<std::array<Vec2, 2>> ends;
  const std::vector<Ink> inks = ink_of(entities);
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const DxfRecord& one = entities[i];
    const auto on_arc = [&](int code) {
      const double angle = one.number(code) * pi / 180;
      return one.point(10) + one.number(40) * Vec2(std::cos(angle), std::sin(angle));
    };
    if (one.type == "ARC")
      ends.push_back({on_arc(50), on_arc(51)});
    else
      ends.push_back({inks[i].points.front(), inks[i].points.back()});
  }
  return ends;
}

// The corners of recognised arcs are not quite on them.
TEST(DxfCurves, ArcsAsEntitiesEndWhereTheirNeighboursDo) {
  sheet::Stroke slot{{{20, 70}, {50, 70}}, true};
  const drawing::CurvePart right{2, 14, {80, 50}, {20, 0}, {0, 20}, pi / 2, -pi / 2};
  for (const Vec2& p : corners_of(right)) slot.points.push_back(p);
  slot.points[2] += Vec2(0.004, -0.007);
  slot.points[14] += Vec2(-0.003, 0.005);
  const drawing::CurvePart left{15, 27, {20, 50}, {20, 0}, {0, 20}, 1.5 * pi, pi / 2};
  for (const Vec2& p : corners_of(left)) slot.points.push_back(p);
  slot.points.pop_back();
  slot.curves = {right, left};
  const auto entities =
      entities_of(output::to_dxf(one_stroke(slot), {.dxf_arcs = output::DxfArcs::entities}), "v-visible");
  std::map<std::string, int> types;
  for (const DxfRecord& one : entities) {
    ++types[one.type];
    EXPECT_TRUE(one.all(42).empty());
  }
  EXPECT_EQ(types["ARC"], 2);
  EXPECT_EQ(types.count("ELLIPSE"), 0U);
  const auto ends = ends_of(entities);
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (const Vec2& end : ends[i]) {
      double nearest = 1;
      for (std::size_t k = 0; k < ends.size(); ++k)
        if (k != i) nearest = std::min({nearest, glm::distance(end, ends[k][0]), glm::distance(end, ends[k][1])});
      EXPECT_LT(nearest, 1e-12);
    }
  for (const DxfRecord& one : entities)
    if (one.type == "ARC") {
      EXPECT_NEAR(one.number(40), 20, 0.01);
      EXPECT_LT(std::min(glm::distance(one.point(10), right.centre), glm::distance(one.point(10), left.centre)), 0.01);
    }
}

TEST(DxfCurves, EllipsesAmongEntitiesAreFinePolylines) {
  const drawing::CurvePart curve{0, 12, {60, 70}, {30, 0}, {0, 10}, 0, 2 * pi};
  sheet::Stroke stroke{corners_of(curve), true, {}, {}, {}, {}, {curve}};
  stroke.points.pop_back();
  const auto entities =
      entities_of(output::to_dxf(one_stroke(stroke), {.dxf_arcs = output::DxfArcs::entities}), "v-visible");
  ASSERT_EQ(entities.size(), 1U);
  EXPECT_EQ(entities[0].type, "LWPOLYLINE");
  const Ink ink = ink_of(entities)[0];
  EXPECT_TRUE(ink.closed);
  for (std::size_t i = 0; i < ink.points.size(); ++i) {
    const Vec2 middle = (ink.points[i] + ink.points[(i + 1) % ink.points.size()]) / 2.0;
    const Vec2 p = (middle - curve.centre) / Vec2(30, 10);
    EXPECT_GT(glm::length(p), 1 - 0.001 / 10);  // no more than 0.001 mm inside
  }
}

TEST(Dxf, BlocksHaveCoordinatesOfTheirOwn) {
  sheet::Sheet sheet{297, 210, "", {{"top/hatch", {"hatch", 0.25}, {{{{12, 20}, {30, 40}}}}}}};
  sheet.layers[0].hatched.push_back(
      {{{{{10, 20}, {30, 20}, {30, 40}}}}, HatchPattern::steel, 0, 3, {{0, 3, 25}}, {1, 1}});
  sheet.views = {{"top", "top", "1:1", {10, 20}, {30, 40}}};
  const std::string dxf = output::to_dxf(sheet, {.dxf_blocks = true, .dxf_entities = {false, true}});
  for (const DxfRecord& block : table_of(dxf, "BLOCK")) EXPECT_EQ(block.point(10), Vec2(0, 0));
  EXPECT_EQ(table_of(dxf, "INSERT").at(0).point(10), Vec2(20, 30));
  const DxfRecord line = table_of(dxf, "LINE").at(0), hatch = table_of(dxf, "HATCH").at(0);
  EXPECT_EQ(line.point(10), Vec2(-8, -10));
  EXPECT_EQ(line.point(11), Vec2(10, 10));
  // Its line at y = 25 is 5 mm below the middle of the view.
  EXPECT_NEAR(number_in(hatch.all(44).back()), -5, 1e-12);
  EXPECT_EQ(hatch.all(10).at(1), "-10");
}

TEST(Dxf, ViewsAreBlocksOnRequest) {
  sheet::Sheet sheet = random_sheet(297, 210);
  sheet.layers.resize(1);
  sheet.layers[0].name = "top/visible";
  sheet.layers.push_back({"frame", sheet.layers[0].style, {{{{0, 0}, {9, 0}, {9, 9}}, true}}});
  sheet.views = {{"top", "top", "1:1", {10, 20}, {30, 40}}};
  const std::string dxf = output::to_dxf(sheet, {.dxf_blocks = true});
  const std::size_t block = dxf.find("AcDbBlockBegin\n2\ntop\n"), entities = dxf.find("\nENTITIES\n");
  ASSERT_NE(block, std::string::npos);
  EXPECT_LT(block, entities);
  EXPECT_LT(dxf.rfind("\ntop-visible\n"), entities);
  EXPECT_GT(dxf.rfind("\nframe\n"), entities);
  const auto inserts = entities_of(dxf, "0");
  ASSERT_EQ(inserts.size(), 1U);
  EXPECT_EQ(inserts[0].text(2), "top");
  EXPECT_EQ(inserts[0].point(10), Vec2(20, 30));
}

using Ezdxf = Rasters;

TEST_F(Ezdxf, FindsNoFault) {
  if (std::system("/usr/bin/python3 -c 'import ezdxf' 2>/dev/null") != 0) GTEST_SKIP() << "no package python3-ezdxf";
  sheet::Sheet sheet = random_sheet(297, 210);
  const drawing::CurvePart curve{0, 24, {60, 50}, {30, 0}, {0, 10}, 0, 2 * pi};
  sheet::Stroke ellipse{corners_of(curve), true, {}, {}, {}, {}, {curve}};
  ellipse.points.pop_back();
  sheet.layers[1].strokes.push_back(ellipse);
  sheet.layers[1].fills.push_back({{{{80, 20}, {110, 20}, {95, 40}}, {{90, 24}, {100, 24}, {95, 30}}}});
  sheet.layers[1].texts = {{"Gehäuse ⌀12 50% \\P ^J", {10, 65}, 5, 30, sheet::Align::middle}};
  sheet.layers[1].name = "<ä\n>/visible";
  write("sheet.dxf", output::to_dxf(sheet));
  const std::string program =
      "import sys; from ezdxf import recover; document, audit = recover.readfile(sys.argv[1]); "
      "model = document.modelspace(); text = model.query('TEXT')[0]; "
      "print(len(audit.errors), len(audit.fixes), len(model), document.units, text.plain_text(), text.dxf.layer)";
  EXPECT_EQ(run("/usr/bin/python3 -c \"" + program + "\" " + path("sheet.dxf")),
            "0 0 104 4 Gehäuse ⌀12 50% \\P ^J -ä---visible\n");
  sheet.views = {{"<ä\n>", "top", "1:1", {10, 20}, {30, 40}}};
  write("blocks.dxf", output::to_dxf(sheet, {.dxf_blocks = true}));
  const std::string exploded =
      "import sys; from ezdxf import recover; document, audit = recover.readfile(sys.argv[1]); "
      "model = document.modelspace(); [insert.explode() for insert in model.query('INSERT')]; "
      "print(len(audit.errors), len(audit.fixes), len(model))";
  EXPECT_EQ(run("/usr/bin/python3 -c \"" + exploded + "\" " + path("blocks.dxf")), "0 0 104\n");
}

}  // namespace
}  // namespace epura::dxf_test
