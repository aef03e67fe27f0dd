#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>

#include "output/write.hpp"
#include "support.hpp"

namespace epura {
namespace {

constexpr double tolerance = 1e-4;  // mm

pugi::xml_document parse(const std::string& svg) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_buffer(svg.data(), svg.size()));
  return document;
}

// Reads M, L and Z of one path; several lines when there are several M.
std::vector<Ink> ink_of(std::string_view path, double height) {
  std::vector<Ink> lines;
  while (!path.empty()) {
    const char command = path[0];
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find_first_of("MLZ"), path.size());
    if (command == 'Z') {
      lines.back().closed = true;
    } else {
      const auto parts = split(path.substr(0, end), ' ');
      EXPECT_EQ(parts.size(), 2u);
      if (command == 'M') lines.emplace_back();
      lines.back().points.emplace_back(number_in(parts[0]), height - number_in(parts[1]));
    }
    path.remove_prefix(end);
  }
  return lines;
}

std::vector<Ink> ink_of(const pugi::xml_node& layer, double height) {
  std::vector<Ink> lines;
  for (const pugi::xml_node path : layer.children("path"))
    for (Ink& line : ink_of(path.attribute("d").value(), height)) lines.push_back(std::move(line));
  return lines;
}

class SvgOfSize : public testing::TestWithParam<Vec2> {};

TEST_P(SvgOfSize, KeepsCoordinates) {
  const Sheet sheet = random_sheet(GetParam().x, GetParam().y);
  const auto document = parse(to_svg(sheet, {}));
  pugi::xml_node layer = document.child("svg").child("g");
  for (const Layer& drawn : sheet.layers) {
    EXPECT_EQ(layer.attribute("inkscape:label").value(), drawn.name);
    EXPECT_STREQ(layer.attribute("inkscape:groupmode").value(), "layer");
    EXPECT_EQ(layer.attribute("class").value(), drawn.style.name);
    EXPECT_LT(largest_error(drawn.strokes, ink_of(layer, sheet.height)), tolerance);
    layer = layer.next_sibling();
  }
  EXPECT_FALSE(layer);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SvgOfSize,
                         testing::Values(Vec2(297, 210), Vec2(1189, 841), Vec2(123.4567, 33.3333), Vec2(12000, 3000)));

TEST(Svg, IsInMillimetres) {
  const auto document = parse(to_svg(random_sheet(297, 210.5), {}));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.attribute("width").value(), "297mm");
  EXPECT_STREQ(svg.attribute("height").value(), "210.5mm");
  EXPECT_STREQ(svg.attribute("viewBox").value(), "0 0 297 210.5");
  EXPECT_NE(std::string(svg.child("style").text().get()).find(".hidden{stroke-width:0.25;stroke-dasharray:3 0.75}"),
            std::string::npos);
}

TEST(Svg, LinesKnowWhereTheyComeFrom) {
  const Sheet sheet = random_sheet(100, 100, 3);
  const auto document = parse(to_svg(sheet, {}));
  std::set<std::string> ids;
  for (const pugi::xml_node layer : document.child("svg").children("g"))
    for (const pugi::xml_node path : layer.children("path"))
      EXPECT_TRUE(ids.insert(path.attribute("id").value()).second);
  EXPECT_EQ(ids.size(), 7u);
  const pugi::xml_node second = document.child("svg").child("g").child("path").next_sibling();
  EXPECT_STREQ(second.attribute("data-edges").value(), "0:1-2");
  EXPECT_STREQ(second.attribute("data-kind").value(), "crease");
  EXPECT_STREQ(second.attribute("stroke-dasharray").value(), "2.51 0.75");
}

TEST(Svg, DashesStandOnlyWhereTheyDiffer) {
  Sheet sheet = random_sheet(100, 100, 3);
  std::vector<Stroke>& strokes = sheet.layers[0].strokes;
  strokes[0].dashes.dash = 3;  // as the style says
  strokes[1].dashes.dash = 0;  // continuous
  const auto document = parse(to_svg(sheet, {}));
  const pugi::xml_node first = document.child("svg").child("g").child("path");
  EXPECT_FALSE(first.attribute("stroke-dasharray"));
  EXPECT_STREQ(first.next_sibling().attribute("stroke-dasharray").value(), "none");
}

TEST(Svg, PointsAndClosedLinesKeepTheirPlaceAmongManyOthers) {
  // Cairo is given many lines at once; what it wrote must fall apart into the same lines.
  Sheet sheet{100, 100, "many", {{"view/visible", {"visible", 0.5}, {}}}};
  std::vector<Stroke>& strokes = sheet.layers[0].strokes;
  for (int i = 0; i < 9000; ++i) {
    const Vec2 at(i % 100, i / 100.0);
    Stroke stroke;
    stroke.points.push_back(at);
    stroke.points.push_back(i % 3 == 0 ? at : at + Vec2(1, 0.5));
    if (i % 5 == 0) stroke.points.emplace_back(at + Vec2(0.5, 2));
    stroke.closed = i % 10 == 0;
    strokes.push_back(stroke);
  }
  const auto document = parse(to_svg(sheet, {}));
  std::size_t i = 0;
  for (const pugi::xml_node path : document.child("svg").child("g").children("path")) {
    const std::vector<Ink> ink = ink_of(path.attribute("d").value(), 100);
    ASSERT_EQ(ink.size(), 1u) << i;
    EXPECT_LT(glm::distance(ink[0].points.front(), strokes[i].points.front()), tolerance) << i;
    EXPECT_LT(glm::distance(ink[0].points.back(), strokes[i].points.back()), tolerance) << i;
    EXPECT_EQ(ink[0].closed, strokes[i].closed) << i;
    ++i;
  }
  EXPECT_EQ(i, strokes.size());
}

TEST(Svg, PlainHasOnePathForEachPatternAndNoOrigin) {
  Sheet sheet = random_sheet(100, 100, 8);
  for (std::size_t i = 0; i < 8; ++i) sheet.layers[0].strokes[i].dashes.dash = i < 4 ? 3 : 2.5;
  const std::string svg = to_svg(sheet, {true});
  EXPECT_EQ(svg.find("data-"), std::string::npos);
  const auto document = parse(svg);
  const pugi::xml_node hidden = document.child("svg").child("g");
  EXPECT_EQ(std::distance(hidden.begin(), hidden.end()), 2);
  EXPECT_LT(largest_error(sheet.layers[0].strokes, ink_of(hidden, 100)), tolerance);
  const pugi::xml_node visible = hidden.next_sibling();
  EXPECT_EQ(std::distance(visible.begin(), visible.end()), 1);
  EXPECT_LT(largest_error(sheet.layers[1].strokes, ink_of(visible, 100)), tolerance);
}

TEST(Svg, PlainKeepsPathsShort) {
  Sheet sheet{100, 100, "many", {{"view/visible", {"visible", 0.5}, {}}}};
  for (int i = 0; i < 60; ++i) {
    Stroke stroke;
    for (int k = 0; k < 300; ++k) stroke.points.emplace_back(i + k % 7 / 3.0, k / 3.3);
    sheet.layers[0].strokes.push_back(stroke);
  }
  const auto document = parse(to_svg(sheet, {true}));
  const pugi::xml_node layer = document.child("svg").child("g");
  for (const pugi::xml_node path : layer.children("path"))
    EXPECT_LT(std::string_view(path.attribute("d").value()).size(), 100'000U);
  EXPECT_EQ(std::distance(layer.begin(), layer.end()), 5);
  EXPECT_EQ(ink_of(layer, 100).size(), 60U);
}

TEST(Svg, TextCannotBreakOut) {
  Sheet sheet = random_sheet(100, 100, 1);
  sheet.title = "<script>&\"' \x01 \xFF </title>\xC3\xA9";
  sheet.layers[0].name = "\"><script>/hidden";
  sheet.layers[0].strokes[0].edges = "\"/><script/>";
  const std::string svg = to_svg(sheet, {});
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  const auto document = parse(svg);
  EXPECT_STREQ(document.child("svg").child("title").text().get(), "<script>&\"'   \xEF\xBF\xBD </title>\xC3\xA9");
  const pugi::xml_node layer = document.child("svg").child("g");
  EXPECT_EQ(layer.attribute("inkscape:label").value(), sheet.layers[0].name);
  EXPECT_EQ(layer.child("path").attribute("data-edges").value(), sheet.layers[0].strokes[0].edges);
}

TEST(Svg, DotsTouchingLinesAndInkBesideTheSheetStay) {
  Sheet sheet = random_sheet(100, 100, 0);
  std::vector<Stroke>& strokes = sheet.layers[1].strokes;
  const auto add = [&strokes](std::vector<Vec2> points, bool closed) {
    strokes.push_back({std::move(points), closed});
  };
  add({{50, 50}, {50, 50}}, false);
  add({{-300, -200}, {-310, -200.5}}, false);
  add({{1000, 50}, {1010, 51}, {1010, 60}}, true);
  const auto document = parse(to_svg(sheet, {}));
  EXPECT_LT(largest_error(strokes, ink_of(document.child("svg").child("g").next_sibling(), 100)), tolerance);
}

TEST(Svg, AnEmptySheetIsADocument) {
  const auto document = parse(to_svg({10, 10, "", {{"v/visible", {"visible", 0.5}, {}}}}, {}));
  EXPECT_TRUE(document.child("svg").child("g"));
  EXPECT_TRUE(parse(to_svg({10, 10, "", {}}, {})).child("svg"));
}

}  // namespace
}  // namespace epura
