// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/write.hpp"
#include "support.hpp"
#include "svg_reader.hpp"

namespace epura::svg_test {
namespace {

constexpr double tolerance = 1e-4;  // mm

class SvgOfSize : public testing::TestWithParam<Vec2> {};

TEST_P(SvgOfSize, KeepsCoordinates) {
  const sheet::Sheet sheet = random_sheet(GetParam().x, GetParam().y);
  const auto document = parse_svg(output::to_svg(sheet, {}));
  const std::vector<pugi::xml_node> layers = layers_of(document);
  ASSERT_EQ(layers.size(), sheet.layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i)
    EXPECT_LT(largest_error(sheet.layers[i].strokes, ink_of(layers[i], sheet.height)), tolerance);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SvgOfSize,
                         testing::Values(Vec2(297, 210), Vec2(1189, 841), Vec2(123.4567, 33.3333), Vec2(12000, 3000),
                                         Vec2(20000, 20000)));

TEST(Svg, ViewsAreLayersOfLayers) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  for (const char* name : {"top/visible", "a view/visible", "notes", "p12"})
    sheet.layers.push_back({name, sheet.layers[1].style, sheet.layers[1].strokes});
  const auto document = parse_svg(output::to_svg(sheet, {}));
  std::vector<std::string> outline;
  std::set<std::string> ids;
  for (const pugi::xml_node g : document.child("svg").children("g")) {
    outline.emplace_back(g.attribute("inkscape:label").value());
    for (const pugi::xml_node inner : g.children("g"))
      outline.back() += std::string(" ") + inner.attribute("inkscape:label").value();
  }
  EXPECT_EQ(outline, (std::vector<std::string>{"a view hidden visible visible", "top visible", "notes", "p12"}));
  for (const pugi::xpath_node& node : document.select_nodes("//*[@id]"))
    EXPECT_TRUE(ids.insert(node.node().attribute("id").value()).second) << node.node().attribute("id").value();
  for (const pugi::xpath_node& node : document.select_nodes("//g"))
    EXPECT_STREQ(node.node().attribute("inkscape:groupmode").value(), "layer");
  EXPECT_STREQ(layers_of(document)[0].attribute("class").value(), (prefix_of(document) + "-hidden").c_str());
}

// Programs that fill paths would take each for an area of its own.
TEST(Svg, PlainPathsKeepLoopsTogether) {
  sheet::Sheet sheet{200, 200, "", {{"v/visible", {"visible", 0.5}, {}}}};
  for (const double radius : {90.0, 50.0, 10.0}) {
    sheet.layers[0].strokes.push_back({{{0, 0}, {radius, 3}}});
    sheet::Stroke& ring = sheet.layers[0].strokes.emplace_back();
    ring.closed = true;
    for (int i = 0; i < 2500; ++i) {
      const double angle = 2 * std::numbers::pi * i / 2500;
      ring.points.push_back(Vec2(100) + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  const auto document = parse_svg(output::to_svg(sheet, {.plain = true}));
  std::vector<long> loops;
  for (const pugi::xpath_node& path : document.select_nodes("//path")) {
    const std::string data = path.node().attribute("d").value();
    loops.push_back(std::count(data.begin(), data.end(), 'Z'));
  }
  EXPECT_EQ(loops, (std::vector<long>{3, 0}));
}

// 420 x 297 mm, without margins to which a browser would shrink it; a page with drawings has its own size.
TEST(Svg, FilesPrintAtTheirSize) {
  const sheet::Sheet sheet = random_sheet(420, 297, 1);
  EXPECT_STREQ(parse_svg(output::to_svg(sheet, {})).child("svg").child("style").text().get(),
               "@page{size:420mm 297mm;margin:0}");
  EXPECT_EQ(output::to_svg(sheet, {.is_inline = true}).find("@page"), std::string::npos);
}

TEST(Svg, NamesAndRulesAreItsOwn) {
  sheet::Sheet sheet = random_sheet(100, 100, 3);
  sheet.layers[0].fills = {{{{{10, 10}, {20, 10}, {10, 20}}}}};
  sheet.layers[0].texts = {{"hidden", {10, 10}, 3.5, 0, sheet::Align::left, "border hidden"}, {"12", {10, 10}, 3.5}};
  output::VectorOptions as_text, named;
  as_text.text = SvgText::text;
  named.id_prefix = "left_1-x";
  std::set<std::string> prefixes;
  for (const output::VectorOptions& options : {output::VectorOptions(), as_text, named}) {
    const auto document = parse_svg(output::to_svg(sheet, options));
    const std::string prefix = prefix_of(document);
    prefixes.insert(prefix);
    std::vector<std::string> names;
    for (const char* attribute : {"id", "class"})
      for (const pugi::xpath_node& node : document.select_nodes((std::string("//*[@") + attribute + "]").c_str()))
        if (node.node() != document.child("svg")) names.emplace_back(node.node().attribute(attribute).value());
    EXPECT_GT(names.size(), 10U);
    for (const std::string& name : names) {
      EXPECT_TRUE(name.starts_with(prefix + "-")) << name;
      EXPECT_EQ(name.find(' '), std::string::npos) << name;
    }
    const std::string rules = document.child("svg").child("metadata").next_sibling("style").text().get();
    for (const std::string_view rule : split(rules, '}'))
      EXPECT_TRUE(rule.empty() || rule.starts_with((&rule[0] == rules.data() ? "#" : "\n#") + prefix)) << rule;
  }
  ASSERT_EQ(prefixes.size(), 2U);
  EXPECT_TRUE(prefixes.contains(named.id_prefix));
}

TEST(Svg, DrawingsThatDifferHaveOtherPrefixes) {
  const sheet::Sheet sheet = random_sheet(100, 100, 9);
  sheet::Sheet moved = sheet, renamed = sheet, titled = sheet, cut = sheet;
  moved.layers[1].strokes[4].points[1].x += 0.001;
  renamed.layers[0].name = "other/hidden";
  titled.title = "Bracket";
  cut.layers[1].strokes.pop_back();
  std::set<std::string> prefixes;
  for (const sheet::Sheet& one : {sheet, moved, renamed, titled, cut})
    prefixes.insert(prefix_of(parse_svg(output::to_svg(one, {}))));
  EXPECT_EQ(prefixes.size(), 5U);
  EXPECT_EQ(prefixes.count(prefix_of(parse_svg(output::to_svg(sheet, {true})))), 1U);
}

TEST(Svg, PrefixesBeginIds) {
  for (const char* good : {"a", "Left-2_b"}) EXPECT_EQ(output::checked_id_prefix(good, "--id-prefix"), good);
  for (const std::string& bad :
       std::vector<std::string>{"", "1a", "-a", "_a", "a b", "a.b", "\xC3\xA4", "a\">", std::string(65, 'a')})
    EXPECT_THROW(output::checked_id_prefix(bad, "--id-prefix"), Error) << bad;
}

TEST(Svg, IsInMillimetres) {
  const auto document = parse_svg(output::to_svg(random_sheet(297, 210.5), {}));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.attribute("width").value(), "297mm");
  EXPECT_STREQ(svg.attribute("height").value(), "210.5mm");
  EXPECT_STREQ(svg.attribute("viewBox").value(), "0 0 297 210.5");
  const pugi::xml_node hidden = layers_of(document)[0];
  EXPECT_STREQ(hidden.attribute("stroke-width").value(), ".25");
  EXPECT_STREQ(hidden.attribute("stroke-dasharray").value(), "3 .75");
  EXPECT_FALSE(hidden.next_sibling().attribute("stroke-dasharray"));
}

TEST(Svg, LinesKnowWhereTheyComeFrom) {
  const sheet::Sheet sheet = random_sheet(100, 100, 3);
  const auto document = parse_svg(output::to_svg(sheet, {}));
  const std::vector<pugi::xml_node> layers = layers_of(document);
  EXPECT_STREQ(layers[0].attribute("data-visible").value(), "0");
  EXPECT_STREQ(layers[1].attribute("data-visible").value(), "1");
  EXPECT_STREQ(layers[0].attribute("data-model").value(), "0");
  const pugi::xml_node second = layers[0].child("path").next_sibling();
  EXPECT_STREQ(second.attribute("id").value(), (prefix_of(document) + "-1").c_str());
  EXPECT_STREQ(second.attribute("data-edge").value(), "1-2");
  EXPECT_STREQ(second.attribute("data-kind").value(), "crease");
  EXPECT_STREQ(second.attribute("stroke-dasharray").value(), "2.51 .75");
}

TEST(Svg, LinesOfSeveralModelsSayWhichTheyDraw) {
  sheet::Sheet sheet = random_sheet(100, 100, 3);
  const std::vector<std::vector<sheet::ModelEdge>> edges = {
      {{12, {0, 1}}, {12, {1, 2}}}, {{1, {0, 1}}}, {{1, {0, 1}}, {12, {0, 1}}}, {}};
  sheet.layers[0].strokes.assign(edges.size(), sheet.layers[0].strokes[0]);
  for (std::size_t i = 0; i < edges.size(); ++i) sheet.layers[0].strokes[i].edges = edges[i];
  const auto document = parse_svg(output::to_svg(sheet, {}));
  const pugi::xml_node layer = layers_of(document)[0];
  EXPECT_FALSE(layer.attribute("data-model"));
  std::vector<std::string> found;
  for (const pugi::xml_node path : layer.children("path"))
    found.push_back(std::string(path.attribute("data-model").value()) + "|" + path.attribute("data-edge").value());
  EXPECT_EQ(found, (std::vector<std::string>{"12|0-1 1-2", "1|0-1", "|1:0-1 12:0-1", "|"}));
}

TEST(Svg, HasTheMetadataThatInkscapeShows) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  sheet.title = "Bracket <&";
  sheet.views = {{"front", "front", "1:2", {0, 0}, {50, 50}}, {"round", "isometric", "", {50, 0}, {99, 50}}};
  sheet.facts = {{"author", "N. N."}, {"number", "B-7"}, {"scale", "1:2"}};
  const auto document = parse_svg(output::to_svg(sheet, {}));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.child("desc").text().get(), "front 1:2, round (isometric)");
  const pugi::xml_node work = svg.child("metadata").child("rdf:RDF").child("cc:Work");
  EXPECT_STREQ(work.child("dc:title").text().get(), "Bracket <&");
  EXPECT_STREQ(work.child("dc:creator").child("cc:Agent").child("dc:title").text().get(), "N. N.");
  EXPECT_STREQ(work.child("dc:identifier").text().get(), "B-7");
  EXPECT_STREQ(work.child("dc:description").text().get(), "front 1:2, round (isometric)\nscale: 1:2");
}

TEST(Svg, DecimalsAreThoseAskedForAndDoNotAddUp) {
  sheet::Sheet sheet{1000, 1000, "", {{"view/visible", {"visible", 0.5}, {}}}};
  sheet::Stroke stroke;
  for (int i = 0; i < 5000; ++i) stroke.points.emplace_back(i * 0.1333333, 500 + 100 * std::sin(i * 0.01));
  sheet.layers[0].strokes.push_back(stroke);
  for (const auto& [decimals, max] : {std::pair{1, 0.0708}, {3, 0.000708}, {4, 0.0000758}, {5, 0.0000121}}) {
    const auto document = parse_svg(output::to_svg(sheet, {false, 300, decimals}));
    const double error = largest_error(sheet.layers[0].strokes, ink_of(layers_of(document)[0], 1000));
    EXPECT_LT(error, max) << decimals;
    EXPECT_GT(error, max / 4) << decimals;
  }
}

TEST(Svg, DashesStandOnlyWhereTheyDiffer) {
  sheet::Sheet sheet = random_sheet(100, 100, 3);
  std::vector<sheet::Stroke>& strokes = sheet.layers[0].strokes;
  strokes[0].dashes.dash = 3;  // as the style says
  strokes[1].dashes.dash = 0;  // continuous
  const auto document = parse_svg(output::to_svg(sheet, {}));
  const pugi::xml_node first = layers_of(document)[0].child("path");
  EXPECT_FALSE(first.attribute("stroke-dasharray"));
  EXPECT_STREQ(first.next_sibling().attribute("stroke-dasharray").value(), "none");
}

TEST(Svg, PointsAndClosedLinesKeepTheirPlaceAmongManyOthers) {
  // Cairo is given many lines at once; what it wrote must fall apart into the same lines.
  sheet::Sheet sheet{100, 100, "many", {{"view/visible", {"visible", 0.5}, {}}}};
  std::vector<sheet::Stroke>& strokes = sheet.layers[0].strokes;
  for (int i = 0; i < 9000; ++i) {
    const Vec2 at(i % 100, i / 100.0);
    sheet::Stroke stroke;
    stroke.points.push_back(at);
    stroke.points.push_back(i % 3 == 0 ? at : at + Vec2(1, 0.5));
    if (i % 5 == 0) stroke.points.emplace_back(at + Vec2(0.5, 2));
    stroke.closed = i % 10 == 0;
    strokes.push_back(stroke);
  }
  const auto document = parse_svg(output::to_svg(sheet, {}));
  std::size_t i = 0;
  for (const pugi::xml_node path : layers_of(document)[0].children("path")) {
    const std::vector<Ink> ink = ink_of(std::string_view(path.attribute("d").value()), 100);
    ASSERT_EQ(ink.size(), 1u) << i;
    EXPECT_LT(glm::distance(ink[0].points.front(), strokes[i].points.front()), tolerance) << i;
    EXPECT_LT(glm::distance(ink[0].points.back(), strokes[i].points.back()), tolerance) << i;
    EXPECT_EQ(ink[0].closed, strokes[i].closed) << i;
    ++i;
  }
  EXPECT_EQ(i, strokes.size());
}

TEST(Svg, PlainHasOnePathForEachPatternAndNoOrigin) {
  sheet::Sheet sheet = random_sheet(100, 100, 8);
  for (std::size_t i = 0; i < 8; ++i) sheet.layers[0].strokes[i].dashes.dash = i < 4 ? 3 : 2.5;
  const std::string svg = output::to_svg(sheet, {true});
  EXPECT_EQ(svg.find("data-"), std::string::npos);
  const auto document = parse_svg(svg);
  const pugi::xml_node hidden = layers_of(document)[0];
  EXPECT_EQ(std::distance(hidden.begin(), hidden.end()), 2);
  EXPECT_LT(largest_error(sheet.layers[0].strokes, ink_of(hidden, 100)), tolerance);
  const pugi::xml_node visible = hidden.next_sibling();
  EXPECT_EQ(std::distance(visible.begin(), visible.end()), 1);
  EXPECT_LT(largest_error(sheet.layers[1].strokes, ink_of(visible, 100)), tolerance);
}

TEST(Svg, PlainKeepsPathsShort) {
  sheet::Sheet sheet{100, 100, "many", {{"view/visible", {"visible", 0.5}, {}}}};
  for (int i = 0; i < 60; ++i) {
    sheet::Stroke stroke;
    for (int k = 0; k < 300; ++k) stroke.points.emplace_back(i + k % 7 / 3.0, k / 3.3);
    sheet.layers[0].strokes.push_back(stroke);
  }
  const auto document = parse_svg(output::to_svg(sheet, {true}));
  const pugi::xml_node layer = layers_of(document)[0];
  for (const pugi::xml_node path : layer.children("path"))
    EXPECT_LT(std::string_view(path.attribute("d").value()).size(), 100'000U);
  EXPECT_EQ(std::distance(layer.begin(), layer.end()), 5);
  EXPECT_EQ(ink_of(layer, 100).size(), 60U);
}

TEST(Svg, TextCannotBreakOut) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  sheet.title = "<script>&\"' \x01 \xFF </title>\xC3\xA9";
  sheet.layers[0].name = "\"><script>/hidden";
  const std::string svg = output::to_svg(sheet, {});
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  const auto document = parse_svg(svg);
  EXPECT_STREQ(document.child("svg").child("title").text().get(), "<script>&\"'   \xEF\xBF\xBD </title>\xC3\xA9");
  const pugi::xml_node layer = layers_of(document)[0];
  EXPECT_STREQ(layer.parent().attribute("inkscape:label").value(), "\"><script>");
}

TEST(Svg, DotsTouchingLinesAndInkBesideTheSheetStay) {
  sheet::Sheet sheet = random_sheet(100, 100, 0);
  std::vector<sheet::Stroke>& strokes = sheet.layers[1].strokes;
  const auto add = [&strokes](std::vector<Vec2> points, bool closed) {
    strokes.push_back({std::move(points), closed});
  };
  add({{50, 50}, {50, 50}}, false);
  add({{-300, -200}, {-310, -200.5}}, false);
  add({{1000, 50}, {1010, 51}, {1010, 60}}, true);
  const auto document = parse_svg(output::to_svg(sheet, {}));
  EXPECT_LT(largest_error(strokes, ink_of(layers_of(document)[1], 100)), tolerance);
}

TEST(Svg, AnEmptySheetIsADocument) {
  const auto document = parse_svg(output::to_svg({10, 10, "", {{"v/visible", {"visible", 0.5}, {}}}}, {}));
  EXPECT_EQ(layers_of(document).size(), 1u);
  EXPECT_TRUE(parse_svg(output::to_svg({10, 10, "", {}}, {})).child("svg"));
}

}  // namespace
}  // namespace epura::svg_test
