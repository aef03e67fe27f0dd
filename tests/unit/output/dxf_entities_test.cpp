// SPDX-License-Identifier: Apache-2.0
// Hatches, dimensions, leaders, tolerance frames and tables that are one entity each.
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

// A note whose leader ends at a dot, the leader of something else, and a line that belongs to neither.
sheet::Layer notes_layer() {
  sheet::Layer layer{"front/notes", {"note", 0.25}, {}};
  const auto line = [&](std::vector<Vec2> points) { layer.strokes.push_back({std::move(points)}); };
  line({{1, 2}, {3, 4}});
  line({{10, 10}, {20, 30}, {50, 30}});
  line({{70, 10}, {60, 20}, {57, 20}});
  layer.fills = {{{{{10, 10}, {11, 10}, {10, 11}}}}, {{{{70, 10}, {71, 10}, {70, 11}}}}};
  layer.texts = {{"free {text}", {5, 5}, 3.5}, {"free text", {21, 32}, 3.5}};
  sheet::LeaderObject note{
      {{10, 10}, {20, 30}, {50, 30}}, LeaderEnd::dot, 3.5, {"ream {⌀}", "and polish"}, {20, 42}, 3.5, 30};
  note.strokes = {1, 2};
  note.fills = {0, 1};
  note.texts = {1, 2};
  sheet::LeaderObject leader{{{70, 10}, {60, 20}, {57, 20}}, LeaderEnd::arrow, 3.5};
  leader.strokes = {2, 3};
  leader.fills = {1, 2};
  leader.texts = {2, 2};
  layer.leaders = {note, leader};
  return layer;
}

TEST(DxfLeaders, StandForTheirInk) {
  const std::string dxf = output::to_dxf(sheet_with(notes_layer()), {.dxf_entities = {.leaders = true}});
  const auto entities = entities_of(dxf, "front-notes");
  EXPECT_EQ(count(entities, "LINE"), 1);
  EXPECT_EQ(count(entities, "LWPOLYLINE"), 0);
  EXPECT_EQ(count(entities, "HATCH"), 0);
  EXPECT_EQ(count(entities, "TEXT"), 1);
  const std::vector<DxfRecord> leaders = table_of(dxf, "MULTILEADER");
  ASSERT_EQ(leaders.size(), 2U);
  // Text and underline begin at the bend: the first vertex is what the leader means.
  EXPECT_EQ(leaders[0].all(304), (std::vector<std::string>{"ream \\{⌀\\}\\Pand polish", "LEADER_LINE{"}));
  const auto x = leaders[0].all(10), y = leaders[0].all(20);
  EXPECT_EQ(std::vector(x.begin(), x.begin() + 3), (std::vector<std::string>{"20", "20", "10"}));
  EXPECT_EQ(std::vector(y.begin(), y.begin() + 3), (std::vector<std::string>{"30", "30", "10"}));
  EXPECT_EQ(leaders[0].text(12), "20");
  EXPECT_EQ(leaders[0].text(22), "42");
  // Without a text, the leader ends where its line does.
  EXPECT_EQ(leaders[1].text(172), "0");
  const auto other = leaders[1].all(10);
  EXPECT_EQ(std::vector(other.begin(), other.begin() + 4), (std::vector<std::string>{"57", "57", "70", "60"}));
  // The dot is a block, the arrow the usual one.
  const std::vector<DxfRecord> blocks = table_of(dxf, "BLOCK_RECORD");
  const auto dot = std::ranges::find(blocks, "_DotSmall", [](const DxfRecord& one) { return one.text(2); });
  ASSERT_NE(dot, blocks.end());
  EXPECT_EQ(leaders[0].text(342), dot->text(5));
  EXPECT_EQ(leaders[1].text(342), "");
  const std::vector<DxfRecord> styles = table_of(dxf, "MLEADERSTYLE");
  ASSERT_EQ(styles.size(), 1U);
  EXPECT_EQ(leaders[0].all(340).back(), styles[0].text(5));
}

// Two rows that share a symbol; their texts are in another layer.
std::vector<sheet::Layer> frame_layers() {
  sheet::Layer notes{"front/notes", {"note", 0.25}, {}}, symbols{"front/symbols", {"symbol", 0.35}, {}};
  notes.texts = {{"0.1", {10, 10}, 3.5}, {"A", {20, 10}, 3.5}, {"free", {50, 50}, 3.5}};
  symbols.strokes = {{{{0, 0}, {40, 0}, {40, 7}, {0, 7}}, true}, {{{90, 90}, {91, 91}}}};
  sheet::ToleranceObject frame{{{Characteristic::position, {{{"⌀0.1"}, {"M", true}}, {{"A"}}, {{"B"}, {"F", true}}}},
                                {Characteristic::position, {{{"0.02"}}}}},
                               {30, 40},
                               3.5};
  frame.texts = {0, 2};
  notes.tolerances = {frame};
  sheet::ToleranceObject ink;
  ink.strokes = {0, 1};
  symbols.tolerances = {ink};
  return {notes, symbols};
}

TEST(DxfTolerances, StandForTheirInk) {
  sheet::Sheet sheet{297, 210, "entities", frame_layers()};
  const std::string dxf = output::to_dxf(sheet, {.dxf_entities = {.tolerances = true}});
  const auto notes = entities_of(dxf, "front-notes"), symbols = entities_of(dxf, "front-symbols");
  EXPECT_EQ(count(notes, "TEXT"), 1);
  EXPECT_EQ(count(symbols, "LINE"), 1);
  EXPECT_EQ(count(symbols, "LWPOLYLINE"), 0);
  EXPECT_EQ(count(symbols, "TOLERANCE"), 0);
  ASSERT_EQ(count(notes, "TOLERANCE"), 1);
  const DxfRecord frame = table_of(dxf, "TOLERANCE")[0];
  EXPECT_EQ(frame.text(1), "{\\Fgdt;j}%%v{\\Fgdt;n}0.1{\\Fgdt;m}%%vA%%vB(F)^J{\\Fgdt;j}%%v0.02");
  EXPECT_EQ(frame.point(10), Vec2(30, 40));
  const std::vector<DxfRecord> styles = table_of(dxf, "DIMSTYLE");
  const auto style = std::ranges::find(styles, frame.text(3), [](const DxfRecord& one) { return one.text(2); });
  ASSERT_NE(style, styles.end());
  EXPECT_EQ(style->number(140) + 2 * style->number(147), 7);  // a frame is two heights of its texts high
}

// A title above two columns.
sheet::Layer table_layer() {
  sheet::Layer layer{"sheet/tables", {"table", 0.25}, {}};
  for (const double y : {100.0, 94.0, 88.0}) layer.strokes.push_back({{{20, y}, {60, y}}});
  layer.strokes.push_back({{{0, 0}, {1, 1}}});
  layer.texts = {{"Holes", {21, 95}, 2.5},
                 {"A", {21, 89}, 2.5},
                 {"10", {59, 89}, 2.5, 0, sheet::Align::right},
                 {"x", {5, 5}, 2.5}};
  sheet::TableObject table{{20, 100}, {10, 30}, 6, 2.5, 1, {{{"Holes"}}, {{"A"}, {"10", true}}}};
  table.strokes = {0, 3};
  table.texts = {0, 3};
  layer.tables = {table};
  return layer;
}

TEST(DxfTables, HaveABlockWithTheirInk) {
  const std::string dxf = output::to_dxf(sheet_with(table_layer()), {.dxf_entities = {.tables = true}});
  const std::size_t entities = dxf.find("0\nSECTION\n2\nENTITIES\n");
  const auto in_block = entities_of(dxf.substr(0, entities), "sheet-tables");
  const auto in_model = entities_of(dxf.substr(entities), "sheet-tables");
  EXPECT_EQ(count(in_block, "LINE"), 3);
  EXPECT_EQ(count(in_block, "TEXT"), 3);
  EXPECT_EQ(ink_of(in_block).front().points.front(), Vec2(0, 0));  // from the corner of the table
  EXPECT_EQ(count(in_model, "LINE"), 1);
  EXPECT_EQ(count(in_model, "TEXT"), 1);
  ASSERT_EQ(count(in_model, "ACAD_TABLE"), 1);
  const DxfRecord& table = in_model.back();
  EXPECT_EQ(table.text(2), "*T1");
  EXPECT_EQ(Vec2(number_in(table.all(10)[0]), number_in(table.all(20)[0])), Vec2(20, 100));
  EXPECT_EQ(table.all(141), (std::vector<std::string>{"6", "6"}));
  EXPECT_EQ(table.all(142), (std::vector<std::string>{"10", "30"}));
  EXPECT_EQ(table.all(302), (std::vector<std::string>{"Holes", "", "A", "10"}));
  EXPECT_EQ(table.all(175), (std::vector<std::string>{"2", "1", "1", "1"}));  // the title is as wide as both columns
  EXPECT_EQ(table.all(173), (std::vector<std::string>{"0", "1", "0", "0"}));
  EXPECT_EQ(table.all(170), (std::vector<std::string>{"4", "4", "4", "6"}));
  const std::vector<DxfRecord> blocks = table_of(dxf, "BLOCK_RECORD");
  const auto block = std::ranges::find(blocks, "*T1", [](const DxfRecord& one) { return one.text(2); });
  ASSERT_NE(block, blocks.end());
  EXPECT_EQ(table.text(343), block->text(5));
  EXPECT_EQ(table.text(342), table_of(dxf, "TABLESTYLE")[0].text(5));
}

using Ezdxf = Rasters;

TEST_F(Ezdxf, FindsNoFaultInLeadersTolerancesAndTables) {
  if (std::system("/usr/bin/python3 -c 'import ezdxf' 2>/dev/null") != 0) GTEST_SKIP() << "no package python3-ezdxf";
  sheet::Sheet sheet{297, 210, "entities", frame_layers()};
  sheet.layers.push_back(notes_layer());
  sheet.layers.push_back(table_layer());
  sheet.layers[2].name = "front/notes-2";
  sheet.views = {{"front", "front", "1:1", {10, 20}, {30, 40}}};
  for (const bool blocks : {false, true}) {
    write("sheet.dxf", output::to_dxf(sheet, {.dxf_blocks = blocks,
                                              .dxf_entities = {.leaders = true, .tolerances = true, .tables = true}}));
    const std::string program =
        "import sys; from ezdxf import recover; document, audit = recover.readfile(sys.argv[1]); "
        "every = [e for b in document.blocks for e in b]; kind = lambda t: [e for e in every if e.dxftype() == t]; "
        "leaders = kind('MULTILEADER'); lines = [l for m in leaders for d in m.context.leaders for l in d.lines]; "
        "print(len(audit.errors), len(audit.fixes), len(leaders), len(kind('TOLERANCE')), len(kind('ACAD_TABLE')), "
        "[len(l.vertices) for l in lines], leaders[0].context.mtext.default_content.split('P')[-1], "
        "len(list(kind('ACAD_TABLE')[0].__virtual_entities__())), "
        "[round(x, 6) for x in list(leaders[0].context.leaders[0].last_leader_point - lines[0].vertices[0])])";
    EXPECT_EQ(run("/usr/bin/python3 -c \"" + program + "\" " + path("sheet.dxf")),
              "0 0 2 1 1 [1, 2] and polish 6 [10.0, 20.0, 0.0]\n")
        << blocks;
  }
}

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
