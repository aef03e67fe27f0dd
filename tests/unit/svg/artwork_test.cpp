// SPDX-License-Identifier: Apache-2.0
#include "svg/artwork.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/error.hpp"

namespace epura::artwork_test {
namespace {

std::string document(const std::string& content, const std::string& size =
                                                     "width=\"100mm\" height=\"50mm\" "
                                                     "viewBox=\"0 0 200 100\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">\n" + content + "\n</svg>\n";
}

svg::Artwork art(const std::string& content) { return svg::read_artwork(document(content), "a.svg"); }

const svg::Shape& shape(const svg::Artwork& art, std::size_t i = 0) { return std::get<svg::Shape>(art.items.at(i)); }
const svg::Words& words(const svg::Artwork& art, std::size_t i = 0) { return std::get<svg::Words>(art.items.at(i)); }

void expect_near(const Vec2& a, const Vec2& b) { EXPECT_LT(glm::distance(a, b), 1e-9) << a.x << ", " << a.y; }

TEST(Artwork, IsInMillimetresWithYUp) {
  const svg::Artwork read = art("<line x1=\"20\" y1=\"10\" x2=\"40\" y2=\"10\" stroke=\"#036\" stroke-width=\"2\"/>");
  expect_near(read.size, {100, 50});
  const svg::Shape& line = shape(read);
  expect_near(line.lines[0].points[0], {10, 45});
  expect_near(line.lines[0].points[1], {20, 45});
  EXPECT_DOUBLE_EQ(line.width, 1);
  EXPECT_EQ(line.stroke, (Colour{0, 0x33, 0x66}));
}

TEST(Artwork, TransformsNest) {
  // Turned about (10, 10) by a right angle: (20, 10) goes to (10, 20); then moved by (4, 6) and doubled.
  const svg::Artwork read =
      art("<g transform=\"scale(2) translate(4,6)\"><path style=\"stroke:black\" "
          "transform=\"rotate(90,10,10)\" d=\"m 20,10 h 10\"/></g>");
  expect_near(shape(read).lines[0].points[0], {14, 50 - 26});
  expect_near(shape(read).lines[0].points[1], {14, 50 - 36});
  EXPECT_DOUBLE_EQ(shape(read).width, 1);
}

TEST(Artwork, StyleSheetsClassesAndAttributesHaveTheirRanks) {
  const svg::Artwork read =
      art("<style>rect{stroke:#f00;fill:none} .thin{stroke-width:.5} #b{stroke:#00f}</style>"
          "<rect id=\"a\" class=\"thin\" stroke=\"#0f0\" width=\"2\" height=\"2\"/>"
          "<rect id=\"b\" width=\"2\" height=\"2\"/><rect id=\"b\" style=\"stroke:white\" width=\"2\" height=\"2\"/>");
  EXPECT_EQ(shape(read, 0).stroke, (Colour{255, 0, 0}));
  EXPECT_DOUBLE_EQ(shape(read, 0).width, 0.25);
  EXPECT_EQ(shape(read, 1).stroke, (Colour{0, 0, 255}));
  EXPECT_EQ(shape(read, 2).stroke, (Colour{255, 255, 255}));
  EXPECT_FALSE(shape(read, 0).fill);
}

TEST(Artwork, BasicShapesHaveTheirOutlines) {
  const svg::Artwork read =
      art("<circle cx=\"20\" cy=\"20\" r=\"10\"/><rect x=\"10\" y=\"10\" width=\"40\" "
          "height=\"20\" rx=\"5\"/><polygon points=\"0,0 10,0 10,10\"/>");
  for (const Vec2& p : shape(read, 0).lines[0].points) EXPECT_NEAR(glm::distance(p, Vec2(10, 40)), 5, 1e-9);
  EXPECT_TRUE(shape(read, 0).lines[0].closed);
  EXPECT_GT(shape(read, 0).lines[0].points.size(), 40U);
  for (const Vec2& p : shape(read, 1).lines[0].points) {
    EXPECT_GE(p.x, 5 - 1e-9);
    EXPECT_LE(p.x, 25 + 1e-9);
    EXPECT_GT(glm::distance(p, Vec2(5, 45)), 2.5 * 0.414 - 1e-3);  // the corner is rounded
  }
  EXPECT_EQ(shape(read, 2).lines[0].points.size(), 3U);
  EXPECT_EQ(shape(read, 2).fill, Colour());  // black by default
}

TEST(Artwork, TextsAsInkscapeWritesThem) {
  const svg::Artwork read = art(
      "<text xml:space=\"preserve\" style=\"font-size:7px;text-anchor:middle\" x=\"20\" y=\"30\" id=\"text1\" "
      "inkscape:label=\"Document type\"><tspan sodipodi:role=\"line\" x=\"20\" y=\"30\" style=\"font-size:10px\">Part "
      "<tspan style=\"font-weight:bold\">drawing</tspan></tspan><tspan x=\"20\" y=\"40\">second</tspan></text>");
  ASSERT_EQ(read.items.size(), 2U);
  EXPECT_EQ(words(read).text, "Part drawing");
  EXPECT_EQ(words(read).name, "document_type");
  EXPECT_EQ(words(read).anchor, svg::TextAnchor::middle);
  EXPECT_DOUBLE_EQ(words(read).size, 5);
  EXPECT_DOUBLE_EQ(words(read, 1).size, 3.5);
  expect_near(words(read).at, {10, 35});
  EXPECT_EQ(words(read).where, "a.svg:2");
}

TEST(Artwork, StretchedTextsKeepTheirHeight) {
  const svg::Artwork read = art("<text transform=\"scale(.5,2)\" x=\"40\" y=\"8\" style=\"font-size:4px\">A</text>");
  EXPECT_DOUBLE_EQ(words(read).size, 4);
  expect_near(words(read).at, {10, 50 - 8});
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_TRUE(read.warnings[0].starts_with("a.svg:2: a text that is wider or narrower"));
}

TEST(Artwork, TurnedTextsRunUpwards) {
  const svg::Artwork read = art("<text transform=\"rotate(-90)\" x=\"-40\" y=\"8\" style=\"font-size:8px\">A</text>");
  EXPECT_NEAR(words(read).angle, 90, 1e-9);
  expect_near(words(read).at, {4, 50 - 20});
}

TEST(Artwork, AreasAreBoxesOfNamedElements) {
  constexpr std::array<std::string_view, 1> wanted = {"title_block"};
  const svg::Artwork read = svg::read_artwork(
      document("<g inkscape:label=\"Title block\" transform=\"translate(100,40)\"><rect width=\"80\" height=\"50\"/>"
               "</g><rect id=\"other\" width=\"9\" height=\"9\"/>"),
      "a.svg", wanted);
  ASSERT_EQ(read.areas.size(), 1U);
  expect_near(read.areas[0].min, {50, 5});
  expect_near(read.areas[0].max, {90, 30});
}

TEST(Artwork, HiddenLayersShowNothing) {
  EXPECT_TRUE(
      art("<g style=\"display:none\"><image href=\"x.png\"/><rect width=\"9\" height=\"9\"/></g>").items.empty());
}

// Halfway between the ends: between the stops at 0.25 and 0.75, and on white where it is transparent.
TEST(Artwork, GradientsAreDrawnInTheirMiddleColour) {
  const svg::Artwork read =
      art("<defs><linearGradient id=\"stops\"><stop offset=\"0\" stop-color=\"#f00\"/><stop offset=\".25\" "
          "style=\"stop-color:#000000;stop-opacity:1\"/><stop offset=\"75%\" stop-color=\"#6496c8\"/></linearGradient>"
          "<radialGradient id=\"ball\" xlink:href=\"#stops\"/><radialGradient id=\"ring\" href=\"#ring\"/>"
          "<linearGradient id=\"glass\"><stop stop-color=\"#0000ff\" stop-opacity=\"0.5\"/></linearGradient></defs>\n"
          "<rect width=\"9\" height=\"9\" fill=\"url(#ball)\"/><rect width=\"9\" height=\"9\" fill=\"url(#glass)\"/>");
  EXPECT_EQ(shape(read, 0).fill, (Colour{50, 75, 100}));
  EXPECT_EQ(shape(read, 1).fill, (Colour{128, 128, 255}));
  ASSERT_EQ(read.warnings.size(), 1U);
  EXPECT_EQ(read.warnings[0], "a.svg:3: 2 gradients are drawn in their middle colours, this is the first");
  EXPECT_THROW((void)art("<defs><radialGradient id=\"ring\" href=\"#ring\"/></defs><rect width=\"9\" height=\"9\" "
                         "fill=\"url(#ring)\"/>"),
               Error);
}

TEST(Artwork, TransparentColoursAreAsOnWhitePaper) {
  const svg::Artwork read =
      art("<g opacity=\"50%\"><rect width=\"9\" height=\"9\" fill=\"#000\" fill-opacity=\"0.4\" stroke=\"#f00\" "
          "style=\"stroke-opacity:0\"/></g>"
          "<rect width=\"9\" height=\"9\" fill=\"#123456\" style=\"fill-opacity:0.9999\"/>");
  EXPECT_EQ(shape(read, 0).fill, (Colour{204, 204, 204}));
  EXPECT_FALSE(shape(read, 0).stroke);
  EXPECT_EQ(shape(read, 1).fill, (Colour{0x12, 0x34, 0x56}));
  EXPECT_EQ(read.warnings,
            (std::vector<std::string>{"a.svg:2: a transparent colour is drawn as it is on white paper"}));
}

// As FreeCAD's TechDraw writes templates: fields by an attribute, areas in comments, sizes without a unit.
TEST(Artwork, TemplatesOfFreeCadHaveFieldsAndAreas) {
  constexpr std::array<std::string_view, 2> wanted = {"drawing_area", "title_block"};
  const svg::Artwork read = svg::read_artwork(
      "<svg xmlns:freecad=\"https://www.freecad.org/wiki/index.php?title=Svg_Namespace\" width=\"420\" height=\"297\" "
      "viewBox=\"0 0 420 297\"><!-- Working space 10 12 410 287 --><!-- Title block   270 223\n410 287 -->"
      "<text x=\"20\" y=\"30\" font-size=\"3.5\" id=\"text7\" freecad:editable=\"AUTHOR_NAME\">A name</text>"
      "<text x=\"20\" y=\"40\" font-size=\"3.5\" freecad:editable=\"x\" freecad:autofill=\"page_count\">1</text></svg>",
      "a.svg", wanted);
  expect_near(read.size, {420, 297});
  ASSERT_EQ(read.areas.size(), 2U);
  EXPECT_EQ(read.areas[0].name, "drawing_area");
  expect_near(read.areas[0].min, {10, 10});
  expect_near(read.areas[0].max, {410, 285});
  EXPECT_EQ(read.areas[1].name, "title_block");
  expect_near(read.areas[1].min, {270, 10});
  EXPECT_TRUE(words(read).is_field);
  EXPECT_EQ(words(read).name, "author_name");
  EXPECT_EQ(words(read, 1).name, "page_count");
}

struct Refused {
  const char* content;
  const char* reason;
  const char* hint;
};

class ArtworkRefuses : public testing::TestWithParam<Refused> {};

TEST_P(ArtworkRefuses, WithLineAndHint) {
  try {
    (void)art(std::string("<g>\n") + GetParam().content + "</g>");
    FAIL() << GetParam().content;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.where(), "a.svg:3");
    EXPECT_NE(std::string(error.what()).find(GetParam().reason), std::string::npos) << error.what();
    EXPECT_NE(error.hint().find(GetParam().hint), std::string::npos) << error.hint();
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ArtworkRefuses,
    testing::Values(Refused{"<script>alert(1)</script>", "<script>", "remove"},
                    Refused{"<rect onclick=\"x()\" width=\"1\" height=\"1\"/>", "script", "remove"},
                    Refused{"<image href=\"http://example.org/x.png\"/>", "<image>", "--logo"},
                    Refused{"<use href=\"#a\"/>", "<use>", "Unlink Clone"},
                    Refused{"<rect width=\"1\" height=\"1\" fill=\"url(#g)\"/>", "url(#g)", "flat colour"},
                    Refused{"<rect width=\"1\" height=\"1\" style=\"opacity:half\"/>", "opacity", "0 to 1"},
                    Refused{"<rect width=\"1\" height=\"1\" clip-path=\"url(#c)\"/>", "clip-path", "Release"},
                    Refused{"<path d=\"M 0,0 S 1 1 2 2\"/>", "path", "commands"},
                    Refused{"<rect width=\"1em\" height=\"1\"/>", "width", ""},
                    Refused{"<text x=\"0\" y=\"0\" style=\"font-size:1em\">a</text>", "size", "font-size"},
                    Refused{"<text transform=\"scale(-1,1)\" style=\"font-size:3px\">a</text>", "mirrored", "turn"},
                    Refused{"<text style=\"font-size:0px\">a</text>", "height", "font-size"},
                    Refused{"<text style=\"font-size:-3px\">a</text>", "height", "font-size"},
                    Refused{"<text transform=\"scale(0)\" style=\"font-size:3px\">a</text>", "height", "transform"},
                    Refused{"<text transform=\"scale(1e200) scale(1e200)\" style=\"font-size:3px\">a</text>", "height",
                            ""},
                    Refused{"<path d=\"M0 0L1e308 1e308\"/>", "1 km beyond", "remove"},
                    Refused{"<g transform=\"scale(1e9)\"><rect width=\"1\" height=\"1\"/></g>", "1 km beyond", ""},
                    Refused{"<path d=\"M0 0L1 1\" style=\"stroke-width:1e9\"/>", "1 km beyond", ""},
                    Refused{"<text x=\"1e9\" style=\"font-size:3px\">a</text>", "1 km beyond", ""},
                    Refused{"<g transform=\"skewX(3)\"/>", "transform", ""},
                    Refused{"<style>g > rect{fill:red}</style>", "selector", "classes"}));

TEST(Artwork, NeedsASize) {
  EXPECT_THROW((void)svg::read_artwork(document("", ""), "a.svg"), Error);
  EXPECT_THROW((void)svg::read_artwork("<html/>", "a.svg"), Error);
  EXPECT_THROW((void)svg::read_artwork("<svg width=\"1\"", "a.svg"), Error);
  const svg::Artwork read = svg::read_artwork(document("", "width=\"96\" height=\"1in\""), "a.svg");
  expect_near(read.size, {25.4, 25.4});
}

TEST(Artwork, DashesAreInMillimetres) {
  const svg::Artwork read = art("<path d=\"M0 0H9\" stroke=\"#000\" stroke-dasharray=\"6, 1.5\"/>");
  EXPECT_EQ(shape(read).dashes, (std::vector<double>{3, 0.75}));
}

}  // namespace
}  // namespace epura::artwork_test
