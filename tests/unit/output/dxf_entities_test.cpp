// SPDX-License-Identifier: Apache-2.0
// Hatches and dimensions that are one entity each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dxf_reader.hpp"
#include "output/write.hpp"
#include "rasters.hpp"
#include "support.hpp"

namespace epura::dxf_entities_test {
namespace {

// A square that is hatched by three lines, and a line that belongs to no hatch.
sheet::Layer hatched_layer() {
  sheet::Layer layer{"front/hatch", {"hatch", 0.25}, {}};
  layer.strokes.push_back({{{0, 0}, {1, 1}}});
  for (const double x : {10.0, 20.0, 30.0}) layer.strokes.push_back({{{x, 10}, {x, 40}}});
  layer.hatched.push_back({{{{{5, 10}, {35, 10}, {35, 40}, {5, 40}}, {{15, 20}, {18, 20}, {18, 23}}}},
                           HatchPattern::steel,
                           60,
                           3,
                           {{60, 3, 0}, {60, 3, 0.9}},
                           {1, 4}});
  return layer;
}

// A dimension of 20 mm whose ink is between that of others.
sheet::Layer dimension_layer() {
  sheet::Layer layer{"front/dimensions", {"dimension", 0.25}, {}};
  const auto line = [&](const Vec2& from, const Vec2& to) { layer.strokes.push_back({{from, to}}); };
  line({100, 100}, {120, 100});
  line({50, 60}, {70, 60});
  line({50, 50}, {50, 62});
  layer.fills = {{{{{50, 60}, {53, 60.5}, {53, 59.5}}}}, {{{{1, 1}, {2, 1}, {2, 2}}}}};
  layer.texts = {{"note", {5, 5}, 3.5}, {"20 {⌀}", {60, 61}, 3.5, 0, sheet::Align::middle}};
  sheet::DimensionObject object{sheet::DimensionShape::linear, {{50, 50}, {70, 55}, {70, 60}}};
  object.text = "20 {⌀}";
  object.text_middle = {60, 63};
  object.text_height = object.arrow = 3.5;
  object.gap = object.overshoot = 2;
  object.above = 1;
  object.strokes = {1, 3};
  object.fills = {0, 1};
  object.texts = {1, 2};
  layer.dimensions.push_back(object);
  return layer;
}

sheet::Sheet sheet_with(sheet::Layer layer) { return {297, 210, "entities", {std::move(layer)}}; }

int count(const std::vector<DxfRecord>& records, const std::string& type) {
  return static_cast<int>(
      std::count_if(records.begin(), records.end(), [&type](const auto& one) { return one.type == type; }));
}

TEST(DxfHatches, StandForTheirLines) {
  const auto plain = entities_of(output::to_dxf(sheet_with(hatched_layer())), "front-hatch");
  EXPECT_EQ(count(plain, "LINE"), 4);
  EXPECT_EQ(count(plain, "HATCH"), 0);
  const auto entities =
      entities_of(output::to_dxf(sheet_with(hatched_layer()), {.dxf_entities = {false, true}}), "front-hatch");
  EXPECT_EQ(count(entities, "LINE"), 1);
  ASSERT_EQ(count(entities, "HATCH"), 1);
  const DxfRecord& hatch =
      *std::find_if(entities.begin(), entities.end(), [](const auto& e) { return e.type == "HATCH"; });
  EXPECT_EQ(hatch.text(2), "ANSI32");
  EXPECT_EQ(hatch.all(93), (std::vector<std::string>{"4", "3"}));
  EXPECT_EQ(hatch.text(78), "2");
  EXPECT_EQ(hatch.all(53), (std::vector<std::string>{"60", "60"}));
  // The normal of the lines is at 150 degrees: the second family begins 0.9 mm along it, lines follow every 3 mm.
  const double c = std::cos(150 * M_PI / 180), s = std::sin(150 * M_PI / 180);
  EXPECT_NEAR(number_in(hatch.all(43)[1]), 0.9 * c, 1e-12);
  EXPECT_NEAR(number_in(hatch.all(44)[1]), 0.9 * s, 1e-12);
  EXPECT_NEAR(number_in(hatch.all(45)[0]), 3 * c, 1e-12);
  EXPECT_NEAR(number_in(hatch.all(46)[0]), 3 * s, 1e-12);
}

TEST(DxfDimensions, HaveABlockWithTheirInk) {
  const std::string dxf = output::to_dxf(sheet_with(dimension_layer()), {.dxf_entities = {true, false}});
  const std::size_t entities = dxf.find("0\nSECTION\n2\nENTITIES\n");
  const auto in_blocks = entities_of(dxf.substr(0, entities), "front-dimensions");
  const auto in_model = entities_of(dxf.substr(entities), "front-dimensions");
  EXPECT_EQ(count(in_blocks, "LINE"), 2);
  EXPECT_EQ(count(in_blocks, "TEXT"), 1);
  EXPECT_EQ(count(in_blocks, "HATCH"), 1);
  EXPECT_EQ(count(in_model, "LINE"), 1);
  EXPECT_EQ(count(in_model, "TEXT"), 1);
  EXPECT_EQ(count(in_model, "HATCH"), 1);
  ASSERT_EQ(count(in_model, "DIMENSION"), 1);
  const DxfRecord& dimension = in_model.back();
  EXPECT_EQ(dimension.text(2), "*D1");
  EXPECT_EQ(dimension.point(13), Vec2(50, 50));
  EXPECT_EQ(dimension.point(14), Vec2(70, 55));
  EXPECT_EQ(dimension.point(10), Vec2(70, 60));
  EXPECT_EQ(dimension.text(1), "20 \\{⌀\\}");
  const DxfRecord style = table_of(dxf, "DIMSTYLE")[0];
  EXPECT_EQ(style.number(140), 3.5);
  // Its handle has a code of its own.
  EXPECT_EQ(style.all(105).size(), 1U);
  EXPECT_TRUE(style.all(5).empty());
}

// At 1:2, 20 mm in the file stand for 40 mm of the part, in inches for 40 / 25.4.
TEST(DxfDimensions, MeasureWhatTheySay) {
  sheet::Layer layer = dimension_layer();
  layer.dimensions[0].value = 40;
  sheet::DimensionObject radius = layer.dimensions[0];
  radius.shape = sheet::DimensionShape::radius;
  radius.points = {{3, 4}, {6, 8}};
  radius.value = 5;  // at 1:1
  radius.strokes = radius.fills = radius.texts = {3, 3};
  radius.fills = radius.texts = {2, 2};
  layer.dimensions.push_back(radius);
  const std::string dxf = output::to_dxf(sheet_with(layer), {.dxf_entities = {true, false}});
  std::map<std::string, std::string> factors;
  for (const DxfRecord& style : table_of(dxf, "DIMSTYLE")) factors[style.text(2)] = style.text(144);
  EXPECT_EQ(factors, (std::map<std::string, std::string>{{"STANDARD", "1"}, {"TIMES-2", "2"}}));
  std::vector<DxfRecord> dimensions = table_of(dxf, "DIMENSION");
  ASSERT_EQ(dimensions.size(), 2U);
  EXPECT_EQ(dimensions[0].text(3), "TIMES-2");
  EXPECT_EQ(dimensions[0].text(42), "40");
  EXPECT_EQ(dimensions[1].text(3), "STANDARD");
}

using Ezdxf = Rasters;

TEST_F(Ezdxf, FindsNoFaultInHatchesAndDimensions) {
  if (std::system("/usr/bin/python3 -c 'import ezdxf' 2>/dev/null") != 0) GTEST_SKIP() << "no package python3-ezdxf";
  sheet::Sheet sheet = sheet_with(hatched_layer());
  sheet.layers.push_back(dimension_layer());
  sheet::DimensionObject angle = sheet.layers.back().dimensions[0];
  angle.shape = sheet::DimensionShape::angular;
  angle.points = {{0, 0}, {10, 0}, {0, 10}, {14, 14}};
  angle.strokes = angle.fills = angle.texts = {2, 2};
  sheet.layers.back().dimensions.push_back(angle);
  angle.shape = sheet::DimensionShape::diameter;
  angle.points = {{0, 0}, {10, 0}};
  sheet.layers.back().dimensions.push_back(angle);
  angle.shape = sheet::DimensionShape::radius;
  angle.points = {{3, 4}, {6, 8}};
  angle.leader = 12;
  sheet.layers.back().dimensions.push_back(angle);
  angle.shape = sheet::DimensionShape::ordinate;
  angle.points = {{3, 4}, {26, 18}, {26, 40}};
  sheet.layers.back().dimensions.push_back(angle);
  angle.angle = 90;
  sheet.layers.back().dimensions.push_back(angle);
  sheet.views = {{"front", "front", "1:1", {10, 20}, {30, 40}}};
  for (const bool blocks : {false, true}) {
    write("sheet.dxf", output::to_dxf(sheet, {.dxf_blocks = blocks, .dxf_entities = {true, true}}));
    const std::string program =
        "import sys; from ezdxf import recover; document, audit = recover.readfile(sys.argv[1]); "
        "d = document.query('DIMENSION'); print(len(audit.errors), len(audit.fixes), len(d), "
        "[round(d[i].get_measurement(), 6) for i in (0, 2, 3)], "
        "[(list(d[i].dxf.defpoint2 - d[i].dxf.defpoint)[:2], d[i].dxf.dimtype) for i in (4, 5)], "
        "len(list(d[0].virtual_entities())), "
        "len(document.query('HATCH[solid_fill==0]')))";
    EXPECT_EQ(run("/usr/bin/python3 -c \"" + program + "\" " + path("sheet.dxf")),
              "0 0 6 [20.0, 10.0, 5.0] [([23.0, 14.0], 230), ([23.0, 14.0], 166)] 4 1\n")
        << blocks;
  }
}

}  // namespace
}  // namespace epura::dxf_entities_test
