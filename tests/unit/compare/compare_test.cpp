// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "base/text.hpp"
#include "compare/comparison.hpp"
#include "compare/ink_parts.hpp"
#include "errors.hpp"
#include "output/format.hpp"
#include "plate.hpp"
#include "sheet/lettering.hpp"
#include "sheet/paper.hpp"
#include "sheet/view_lines.hpp"

namespace epura::test::compare_test {
namespace {

TEST(Compare, SaysTheSameOfWaysToWriteAFile) {
  output::VectorOptions plain, coarse, as_text, accessible;
  plain.plain = true;
  coarse.decimals = 3;
  as_text.text = SvgText::text;
  accessible.svg = output::SvgKind::accessible;
  for (const output::VectorOptions& options : {plain, coarse, as_text, accessible})
    EXPECT_EQ(changes(compare::compare(as_svg(plate()), as_svg(plate(), options), 0.001)), "");
}

compare::PictureFile as_pdf(const std::vector<const sheet::Sheet*>& pages) {
  return {false, true, compare::pictures_of_pdf(output::to_pdf(pages), "test.pdf")};
}

TEST(Compare, ReadsLinesAreasAndTextsOfPdf) {
  const sheet::Sheet one = plate();
  const compare::PictureFile before = as_pdf({&one, &one});
  ASSERT_EQ(before.pages.size(), 2U);
  sheet::Sheet edited = plate();
  edited.layers[hidden].strokes.pop_back();
  move(stroke(edited, visible, 1), {0, 1});
  edited.layers[dimension].fills.clear();
  edited.layers[dimension].texts.clear();
  const compare::Comparison comparison = compare::compare(before, as_pdf({&edited, &edited}), 0.001);
  EXPECT_TRUE(comparison.compares_texts);
  const std::string of_page = "removed removed moved";  // text, hidden line, visible line
  const std::string report = compare::format_comparison(comparison, 0.001);
  EXPECT_EQ(changes(comparison), of_page + " " + of_page) << report;
  EXPECT_TRUE(contains(report, "6 more follow from the changed sizes")) << report;  // lines and arrows of the texts
  EXPECT_EQ(comparison.differences.back().page, 2);
  EXPECT_EQ(changes(compare::compare(before, as_pdf({&one, &one}), 0.001)), "");
}

// In any direction, with characters of two fonts, brackets, and texts beside each other on one line.
TEST(Compare, ReadsTextsOfPdfAsTheyWereWritten) {
  sheet::Sheet sheet = plate();
  std::vector<std::string> words = {"2× ⌀16 ↧9", "M8 (2×) \\ 60°", "A", "B", "Rz 6,3"};
  sheet.layers[text].texts.clear();
  sheet.layers[dimension].texts.clear();
  for (std::size_t i = 0; i < words.size(); ++i) {
    sheet::Text& one = sheet.layers[text].texts.emplace_back();
    one.text = words[i];
    one.at = i == 3 ? Vec2(80, 42) : Vec2(50.3, 21 + 7 * static_cast<double>(i));
    one.height = 3.5;
    one.angle = i == 4 ? 90 : 0;
  }
  const compare::PictureFile read = as_pdf({&sheet});
  std::vector<std::string> found;
  for (const compare::PictureText& one : read.pages.at(0).texts) found.push_back(one.words);
  std::sort(words.begin(), words.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, words);
  const auto last = std::find_if(read.pages[0].texts.begin(), read.pages[0].texts.end(),
                                 [](const compare::PictureText& one) { return one.words == "Rz 6,3"; });
  ASSERT_NE(last, read.pages[0].texts.end());
  const double width = sheet::Lettering().width("Rz 6,3", 3.5);
  EXPECT_NEAR(last->min.x, 50.3 - 3.5, 0.01);
  EXPECT_NEAR(last->max.x, 50.3, 0.01);
  EXPECT_NEAR(last->min.y, 49, 0.01);
  EXPECT_NEAR(last->max.y, 49 + width, 0.02);
}

TEST(Compare, TakesChainLinesOfOneTypeForTheSame) {
  sheet::Sheet one = plate(), longer = plate();
  stroke(one, dimension, 0).dashes = {5, 0.75, 0.125, 1};
  stroke(longer, dimension, 0).dashes = {6.1, 0.75, 0.125, 1};
  stroke(longer, dimension, 0).points[1].x += 2;
  EXPECT_EQ(changes(compare::compare(as_svg(one), as_svg(longer), 0.001)), "added");
}

TEST(Compare, SeesTheSameInSvgAndPdf) {
  sheet::Sheet sheet = plate();
  sheet.layers[hidden].strokes.push_back(line({40, 64}, {41, 64}));  // short: continuous
  sheet.layers[dimension].strokes.push_back(line({20, 100}, {60, 100}));
  stroke(sheet, dimension, 1).dashes = {5, 0.75, 0.125, 1};
  const compare::PictureFile pdf{false, true, compare::pictures_of_pdf(output::to_pdf({&sheet}), "test.pdf")};
  EXPECT_EQ(changes(compare::compare(as_svg(sheet), pdf, 0.001)), "");
  sheet::Sheet edited = sheet;
  edited.layers[hidden].strokes.pop_back();
  EXPECT_EQ(changes(compare::compare(as_svg(edited), pdf, 0.001)), "added");
}

TEST(Compare, TellsWhereALineIsMissingAndWhichEdgeItWas) {
  sheet::Sheet edited = plate();
  edited.layers[hidden].strokes.pop_back();
  const compare::Comparison comparison = compare::compare(as_svg(plate()), as_svg(edited), 0.001);
  ASSERT_EQ(comparison.differences.size(), 1U);
  const compare::Difference& difference = comparison.differences[0];
  EXPECT_EQ(difference.view, "front");
  EXPECT_EQ(difference.before, "hidden");
  EXPECT_EQ(difference.origin, "0:3-4");
  EXPECT_NEAR(difference.length, 60, 1e-3);
  EXPECT_NEAR(glm::distance(difference.from, {30, 70}) + glm::distance(difference.to, {90, 70}), 0, 1e-3);
  EXPECT_EQ(compare::format_comparison(comparison, 0.001),
            "removed    front: hidden line, 60 mm, (30, 70) to (90, 70), edge 0:3-4\n"
            "1 difference above 0.001 mm: 1 removed\n");
}

// Between the same ends, in a box of the same size, every wave is where the other line has none.
TEST(Compare, TellsHowFarLinesMovedBetweenTheirEnds) {
  const auto with_waves = [](double height) {
    sheet::Stroke waves;
    for (int i = 0; i <= 60; ++i) waves.points.push_back({30 + i, 62 + (i % 2 == 0 ? height : -height)});
    sheet::Sheet sheet = plate();
    sheet.layers[visible].strokes.push_back(waves);
    return as_svg(sheet);
  };
  const compare::Comparison comparison = compare::compare(with_waves(0.02), with_waves(-0.02), 0.001);
  ASSERT_EQ(changes(comparison), "moved");
  EXPECT_NEAR(comparison.differences[0].distance, 0.04, 0.001);
}

// A polygon with corners on a circle.
sheet::Stroke regular(const Vec2& centre, double radius, int corners) {
  sheet::Stroke polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    polygon.points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  polygon.closed = true;
  return polygon;
}

void move_view(sheet::Sheet& sheet, const Vec2& by) {
  for (const std::size_t layer : {hidden, visible, dimension}) {
    for (sheet::Stroke& stroke : sheet.layers[layer].strokes) move(stroke, by);
    for (sheet::Fill& fill : sheet.layers[layer].fills)
      for (auto& ring : fill.rings)
        for (Vec2& p : ring) p += by;
    for (sheet::Text& text : sheet.layers[layer].texts) text.at += by;
  }
}

// Once, and then what differs in it.
TEST(Compare, TellsAMovedViewOnce) {
  sheet::Sheet edited = plate();
  move_view(edited, {12.5, -1});
  const compare::Comparison moved = compare::compare(as_svg(plate()), as_svg(edited), 0.001);
  EXPECT_EQ(compare::format_comparison(moved, 0.001),
            "moved      front: the whole view, by (12.5, -1) mm\n"
            "1 difference above 0.001 mm: 1 moved\n");
  EXPECT_TRUE(
      contains(compare::to_json(moved, 0.001, "a", "b"), R"("of": "view", "before": null, "after": null, "by")"));
  edited.layers[hidden].strokes.pop_back();
  EXPECT_EQ(changes(compare::compare(as_svg(plate()), as_svg(edited), 0.001)), "moved removed");
}

TEST(Compare, TellsViewsThatMovedAlikeTogether) {
  const auto two_views = [](const Vec2& by) {
    sheet::Sheet sheet = plate();
    move_view(sheet, by);
    sheet.layers.push_back({"top/visible", {"visible", 0.5}, {}});
    sheet.layers.back().strokes = {line(Vec2(20, 120) + by, Vec2(100, 120) + by),
                                   line(Vec2(20, 140) + by, Vec2(90, 140) + by)};
    return sheet;
  };
  const compare::Comparison moved = compare::compare(as_svg(two_views({0, 0})), as_svg(two_views({0, -2})), 0.001);
  EXPECT_EQ(compare::format_comparison(moved, 0.001),
            "moved      front, top: whole views, by (0, -2) mm\n"
            "1 difference above 0.001 mm: 1 moved\n");
}

// Lines that differ by less than the tolerance may be of other lengths when these are rounded, and circles are cut into
// other chords: then the only lines that look the same may be those that stand elsewhere.
TEST(Compare, LeavesAViewWhereMostOfItsInkIs) {
  const auto rows = [](double length, int corners, double row) {
    sheet::Sheet sheet = plate();
    for (int i = 0; i < 4; ++i)
      sheet.layers[visible].strokes.push_back(line({30, 100 + 5 * i}, {30 + length, 100 + 5 * i}));
    sheet.layers[visible].strokes.push_back(line({30, row}, {42, row}));
    sheet.layers[visible].strokes.push_back(regular({60, 130}, 8, corners));
    return sheet;
  };
  sheet::Sheet before = rows(49.9948, 1000, 125), after = rows(49.9952, 1200, 127.5);
  for (sheet::Sheet* sheet : {&before, &after}) {
    sheet->layers[hidden].strokes.clear();
    sheet->layers[dimension] = {"front/dimension", {"dimension", 0.25}, {}};
    auto& strokes = sheet->layers[visible].strokes;
    strokes.erase(strokes.begin(), strokes.begin() + 3);  // of the plate
  }
  const compare::Comparison comparison = compare::compare(as_svg(before), as_svg(after), 0.002);
  ASSERT_EQ(changes(comparison), "moved") << compare::format_comparison(comparison, 0.002);
  EXPECT_FALSE(comparison.differences[0].is_view);
  EXPECT_NEAR(comparison.differences[0].length, 12, 1e-3);
  EXPECT_NEAR(comparison.differences[0].distance, 2.5, 1e-3);
}

// What the space of the models says is not changed.
TEST(Compare, LeavesViewsInPlaceThatAreSaidToBe) {
  sheet::Sheet edited = plate();
  move_view(edited, {0, -1});
  compare::PictureFile after = as_svg(edited);
  after.is_in_place = true;
  EXPECT_GT(compare::compare(as_svg(plate()), after, 0.001).differences.size(), 5U);
}

// The plate becomes 6 mm wider: its right side moves, and what belongs to that.
sheet::Sheet wider_plate() {
  sheet::Sheet edited = plate();
  const auto stretch = [](std::vector<Vec2>& points) {
    for (Vec2& p : points)
      if (p.x > 95) p.x += 6;
  };
  for (const std::size_t layer : {hidden, visible, dimension})
    for (sheet::Stroke& stroke : edited.layers[layer].strokes) stretch(stroke.points);
  edited.layers[dimension].texts[0].text = "86";
  edited.layers[dimension].texts[0].at.x += 3;
  return edited;
}

TEST(Compare, TellsASizeAndCountsWhatFollows) {
  const compare::Comparison comparison = compare::compare(as_svg(plate()), as_svg(wider_plate()), 0.001);
  const std::string words = compare::format_comparison(comparison, 0.001);
  ASSERT_EQ(changes(comparison), "text") << words;
  EXPECT_TRUE(contains(words, "text       front: width '80' -> '86' at (")) << words;
  EXPECT_TRUE(contains(words, "1 difference above 0.001 mm: 1 text; ")) << words;
  EXPECT_GE(comparison.followers, 5U);
  const sheet::Sheet narrow = plate(), wide = wider_plate();
  const compare::Comparison of_pdf = compare::compare(as_pdf({&narrow}), as_pdf({&wide}), 0.001);
  EXPECT_EQ(changes(of_pdf), "text") << compare::format_comparison(of_pdf, 0.001);
  // A view that moved besides is told once more.
  sheet::Sheet moved = wider_plate();
  move_view(moved, {-3, 0});
  EXPECT_EQ(changes(compare::compare(as_svg(plate()), as_svg(moved), 0.001)), "moved text");
}

// What stands at the size of an added hole, and at others that made room for it, is told by its text.
TEST(Compare, TellsASizeThatWasAdded) {
  sheet::Sheet edited = plate();
  edited.layers[visible].strokes.push_back(circle({80, 65}, 4));
  edited.layers[dimension].strokes.push_back(line({83, 68}, {88, 73}));
  edited.layers[dimension].strokes.push_back(line({88, 73}, {94, 73}));
  edited.layers[dimension].fills.push_back({{{{83, 68}, {85, 69}, {84, 70}}}});
  edited.layers[dimension].texts.push_back({"⌀8", {88, 74}, 3.5});
  edited.layers[dimension].texts[0].at.y -= 8;
  edited.layers[dimension].strokes[0] = line({20, 22}, {100, 22});
  const compare::Comparison comparison = compare::compare(as_svg(plate()), as_svg(edited), 0.001);
  EXPECT_EQ(changes(comparison), "added added") << compare::format_comparison(comparison, 0.001);
  EXPECT_GE(comparison.followers, 5U);
}

TEST(Compare, TellsNoSizesThatChangedPlaces) {
  const auto with = [](const std::string& inner, const std::string& outer, const std::string& height) {
    sheet::Sheet sheet = plate();
    sheet::Text text = sheet.layers[dimension].texts[0];
    sheet.layers[dimension].texts[0].text = inner;
    for (const auto& [words, x] : {std::pair(outer, 60.0), std::pair(height, 130.0)}) {
      text.text = words;
      text.at = {x, 23};
      sheet.layers[dimension].texts.push_back(text);
    }
    return sheet;
  };
  const auto words = [&](const sheet::Sheet& before, const sheet::Sheet& after) {
    return compare::format_comparison(compare::compare(as_svg(before), as_svg(after), 0.001), 0.001);
  };
  const std::string swapped = words(with("19", "25", "8"), with("25", "19", "10"));
  EXPECT_TRUE(contains(swapped, "'8' -> '10'") && contains(swapped, "1 difference ")) << swapped;
  const std::string in_place = words(with("20", "30", "8"), with("30", "35", "8"));
  EXPECT_TRUE(contains(in_place, "'20' -> '30'") && contains(in_place, "'30' -> '35'")) << in_place;
}

// Nothing that the size does not explain is among them.
TEST(Compare, ListsWhatDoesNotFollowASize) {
  sheet::Sheet edited = wider_plate();
  edited.layers[hidden].strokes.pop_back();
  stroke(edited, visible, 1).curves.clear();
  for (Vec2& p : stroke(edited, visible, 1).points) p += (p - Vec2(60, 80)) * 0.4;
  EXPECT_EQ(changes(compare::compare(as_svg(plate()), as_svg(edited), 0.001)), "removed removed added text");
  // Without a changed size, every line is told.
  sheet::Sheet same_text = wider_plate();
  same_text.layers[dimension].texts = plate().layers[dimension].texts;
  const compare::Comparison comparison = compare::compare(as_svg(plate()), as_svg(same_text), 0.001);
  EXPECT_EQ(comparison.followers, 0U);
  EXPECT_GE(comparison.differences.size(), 4U);
}

// The hole becomes larger; its note and a dimension that had room elsewhere are placed anew.
TEST(Compare, TellsADiameterOnceWhereverItsNoteStands) {
  const auto with_hole = [](double radius, const std::string& note, const Vec2& at) {
    sheet::Sheet sheet = plate();
    stroke(sheet, visible, 1) = circle({60, 80}, radius);
    sheet.layers[dimension].strokes.push_back(line({60, 80}, at));
    sheet::Text text = sheet.layers[dimension].texts[0];
    text.text = note;
    text.at = at;
    sheet.layers[dimension].texts.push_back(text);
    return sheet;
  };
  const compare::Comparison comparison = compare::compare(as_svg(with_hole(8, "2× ⌀16 ↧9", {75, 110})),
                                                          as_svg(with_hole(9, "2× ⌀18 ↧9", {30, 104})), 0.001);
  const std::string words = compare::format_comparison(comparison, 0.001);
  ASSERT_EQ(changes(comparison), "text") << words;
  EXPECT_TRUE(contains(words, "diameter '2× ⌀16 ↧9' -> '2× ⌀18 ↧9'")) << words;
  // Chords that begin elsewhere.
  sheet::Sheet chords = with_hole(8, "⌀16", {75, 110}), turned = with_hole(9, "⌀18", {75, 110});
  stroke(chords, visible, 1).curves.clear();
  stroke(turned, visible, 1).curves.clear();
  for (Vec2& p : stroke(turned, visible, 1).points)
    p = Vec2(60, 80) + std::cos(0.1) * (p - Vec2(60, 80)) + std::sin(0.1) * Vec2(80 - p.y, p.x - 60);
  EXPECT_EQ(changes(compare::compare(as_svg(chords), as_svg(turned), 0.001)), "text");
  EXPECT_EQ(
      changes(compare::compare(as_svg(with_hole(8, "⌀16", {75, 110})), as_svg(with_hole(9, "⌀16", {75, 110})), 0.001)),
      "removed added")
      << "a hole whose size is not";
}

// Where one note stood, another one stands now: each is told with its own.
TEST(Compare, TellsNotesThatChangedPlacesWithTheirOwn) {
  const auto with_notes = [](const std::vector<std::pair<std::string, Vec2>>& notes) {
    sheet::Sheet sheet = plate();
    for (const auto& [words, at] : notes) {
      sheet::Text text = sheet.layers[dimension].texts[0];
      text.text = words;
      text.at = at;
      sheet.layers[dimension].texts.push_back(text);
    }
    return sheet;
  };
  const compare::Comparison comparison =
      compare::compare(as_svg(with_notes({{"2× ⌀8", {75, 110}}, {"⌀10 ↧12", {30, 104}}})),
                       as_svg(with_notes({{"2× ⌀9", {120, 60}}, {"⌀10 ↧14", {75, 110}}})), 0.001);
  const std::string words = compare::format_comparison(comparison, 0.001);
  EXPECT_EQ(changes(comparison), "text text") << words;
  EXPECT_TRUE(contains(words, "'2× ⌀8' -> '2× ⌀9'") && contains(words, "'⌀10 ↧12' -> '⌀10 ↧14'")) << words;
}

// A layer of which no line is long enough for dashes looks the same in both formats.
TEST(Compare, SeesTheSameInSvgAndPdfOfShortHiddenLines) {
  sheet::Sheet sheet = plate();
  sheet.layers[hidden].strokes = {line({40, 64}, {41, 64}), line({40, 66}, {41.5, 66})};
  const compare::PictureFile pdf{false, true, compare::pictures_of_pdf(output::to_pdf({&sheet}), "test.pdf")};
  EXPECT_EQ(changes(compare::compare(as_svg(sheet), pdf, 0.001)), "");
  output::VectorOptions plain;
  plain.plain = true;
  EXPECT_EQ(changes(compare::compare(pdf, as_svg(sheet, plain), 0.001)), "");
}

TEST(Compare, SeesTheSameColoursInSvgAndPdf) {
  sheet::Sheet sheet = plate();
  sheet.layers[visible].style.colour = {204, 0, 0};
  sheet.layers[dimension].style.colour = {0, 51, 102};
  const auto as_pdf = [](const sheet::Sheet& s) {
    return compare::PictureFile{false, true, compare::pictures_of_pdf(output::to_pdf({&s}), "test.pdf")};
  };
  EXPECT_EQ(changes(compare::compare(as_svg(sheet), as_pdf(sheet), 0.001)), "");
  sheet::Sheet green = sheet;
  green.layers[visible].style.colour = {0, 204, 0};
  EXPECT_TRUE(contains(changes(compare::compare(as_pdf(sheet), as_pdf(green), 0.001)), "restyled"));
}

TEST(Compare, TellsByHowMuchALineMoved) {
  sheet::Sheet edited = plate();
  move(stroke(edited, visible, 2), {0, 0.25});
  const compare::Comparison comparison = compare::compare(as_svg(plate()), as_svg(edited), 0.001);
  ASSERT_EQ(changes(comparison), "moved");
  EXPECT_NEAR(comparison.differences[0].distance, 0.25, 1e-3);
  EXPECT_EQ(comparison.differences[0].origin, "0:5-6");
}

// As files were before styles were attributes and names had prefixes.
TEST(Compare, ReadsStylesThatAreRulesForClasses) {
  const std::string old =
      "<svg width='210mm' height='148mm' viewBox='0 0 210 148'>\n"
      "<style>.hidden,.visible{fill:none;stroke:#000;stroke-linecap:round;stroke-linejoin:round}\n"
      ".hidden{stroke-width:.25;stroke-dasharray:3 .75}\n.visible{stroke-width:.5}\n"
      ".filled{fill:#000;stroke:none;fill-rule:evenodd}</style>\n"
      "<g id='front' inkscape:groupmode='layer' inkscape:label='front'>\n"
      "<g id='front-hidden' inkscape:label='hidden' class='hidden' data-visible='0' data-model='0'>\n"
      "<path id='p0' data-kind='crease' data-edge='1-2' stroke-dasharray='2.9 .75' d='M30 88h60'/>\n"
      "<path id='p1' data-kind='crease' data-edge='3-4' stroke-dasharray='none' d='M30 78h2'/>\n</g>\n"
      "<g id='front-visible' inkscape:label='visible' class='visible' data-visible='1' data-model='0'>\n"
      "<g class='filled'>\n<path d='M20 118l3.5 .6v-1.2Z'/>\n</g>\n"
      "<path id='p2' data-kind='contour' data-edge='5-6' d='M20 98h80v-50'/>\n</g>\n</g>\n</svg>\n";
  sheet::Sheet sheet{
      210, 148, "", {{"front/hidden", {"hidden", 0.25, {3, 0.75}}, {}}, {"front/visible", {"visible", 0.5}, {}}}};
  sheet.layers[0].strokes = {line({30, 60}, {90, 60}, {{0, {1, 2}}}), line({30, 70}, {32, 70}, {{0, {3, 4}}})};
  sheet.layers[0].strokes[0].dashes = {2.9, 0.75};
  sheet.layers[1].strokes = {{{{20, 50}, {100, 50}, {100, 100}}}};
  sheet.layers[1].fills = {{{{{20, 30}, {23.5, 29.4}, {23.5, 30.6}}}}};
  const compare::PictureFile before{false, false, {compare::picture_of_svg(old, "old.svg")}};
  EXPECT_EQ(changes(compare::compare(before, as_svg(sheet), 0.001)), "");
  sheet.layers[0].style.width = 0.35;
  EXPECT_EQ(changes(compare::compare(before, as_svg(sheet), 0.001)), "restyled restyled");
}

TEST(Compare, SeesWhatInkscapeMovedOrSwitchedOff) {
  const std::string svg = output::to_svg(plate(), {});
  const auto with = [&](const std::string& attribute) {
    std::string edited = svg;
    const std::string group = "-front-hidden\"";
    edited.insert(edited.find(group) + group.size(), " " + attribute);
    return changes(
        compare::compare(as_svg(plate()), {false, false, {compare::picture_of_svg(edited, "test.svg")}}, 0.001));
  };
  EXPECT_EQ(with("transform=\"translate(0,1)\""), "moved moved");
  EXPECT_EQ(with("transform=\"rotate(0) scale(1)\""), "");
  EXPECT_EQ(with("style=\"display:none\""), "removed removed");
  EXPECT_EQ(with("style=\"stroke-width:0.7\""), "restyled restyled");
  EXPECT_EQ(with("style=\"stroke:#000000;stroke-dasharray:3,0.75\""), "");
  EXPECT_EQ(with("style=\"stroke:#00f\""), "restyled restyled");
}

// The same for drawing JSON: one view of a triangle with a hidden line in it.
struct JsonLine {
  Vec2 from, to;
  bool visible;
  std::string kind = "crease", edge = "[0, 1]";
};

std::string json_of(const std::vector<JsonLine>& lines, const std::string& view = "front",
                    const std::string& rest = "") {
  const auto point = [](const Vec2& p) { return "[" + format_number(p.x) + ", " + format_number(p.y) + "]"; };
  std::string segments;
  for (const JsonLine& l : lines)
    segments += (segments.empty() ? "" : ", ") + ("{\"from\": " + point(l.from)) + ", \"to\": " + point(l.to) +
                ", \"visible\": " + (l.visible ? "true" : "false") + ", \"kind\": \"" + l.kind +
                "\", \"model\": 0, \"edge\": " + l.edge + ", \"t\": [0, 1]}";
  return R"({"epura": 1, "unit": "mm", "sheet": {"size": [100, 50], "scale": 1}, "views": [{"name": ")" + view +
         R"(", "segments": [)" + segments + "]" + rest + "}]}";
}

const std::vector<JsonLine> triangle = {{{10, 10}, {40, 10}, true, "contour", "[0, 1]"},
                                        {{40, 10}, {10, 40}, true, "contour", "[1, 2]"},
                                        {{10, 40}, {10, 10}, true, "contour", "[2, 0]"},
                                        {{12, 12}, {20, 25}, false, "crease", "[3, 4]"}};

compare::PictureFile as_json(const std::string& json) {
  return {true, false, {compare::picture_of_json(json, "test.json")}};
}

std::string changes_of_json(const std::function<void(std::vector<JsonLine>&)>& edit) {
  std::vector<JsonLine> edited = triangle;
  edit(edited);
  return changes(compare::compare(as_json(json_of(triangle)), as_json(json_of(edited)), 0.001));
}

TEST(CompareJson, DoesNotCountOrderCutsAndNumbers) {
  using Lines = std::vector<JsonLine>;
  EXPECT_EQ(changes_of_json([](Lines&) {}), "");
  EXPECT_EQ(changes_of_json([](Lines& l) { std::reverse(l.begin(), l.end()); }), "");
  EXPECT_EQ(changes_of_json([](Lines& l) { std::swap(l[3].from, l[3].to); }), "");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[1].kind = "crease"; }), "");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[1].edge = "null"; }), "");
  EXPECT_EQ(changes_of_json([](Lines& l) {
              l.push_back(l[1]);
              l[1].to = l.back().from = {30, 20};
            }),
            "");
  EXPECT_EQ(changes(compare::compare(as_json(json_of(triangle)), as_json(json_of(triangle, "renamed")), 0.001)), "");
}

// A block 60 wide in two views, of which the front view keeps its middle on the page as it becomes taller.
std::string json_of_block(double height) {
  sheet::Sheet sheet{420, 297, "block", {}};
  const double low = 212 - height / 2;
  const auto view = [](const char* name, const Vec2& min, const Vec2& max) {
    drawing::ViewDrawing drawing{};
    drawing.name = name;
    const std::vector<Vec2> corners = {min, {max.x, min.y}, max, {min.x, max.y}};
    for (std::size_t i = 0; i < 4; ++i)
      drawing.segments.push_back(
          {corners[i], corners[(i + 1) % 4], true, EdgeKind::contour, 0, {int(i), int(i) + 1}, -1, {0, 1}});
    return drawing;
  };
  const std::vector<drawing::ViewDrawing> views = {view("front", {100, low}, {160, low + height}),
                                                   view("top", {100, low - 80}, {160, low - 50})};
  sheet.layers = {{"front/dimensions", {"dimension", 0.25}, {}}};
  sheet::DimensionObject object{sheet::DimensionShape::linear, {{160, low}, {160, low + height}, {170, low + height}}};
  object.angle = 90;
  object.value = height;
  object.text = format_number(height);
  object.text_middle = {168, low + height / 2};
  sheet.layers[0].dimensions = {object};
  return output::to_json(sheet, 1, views, {});
}

TEST(CompareJson, TellsASizeAndCountsWhatFollows) {
  const compare::Comparison comparison =
      compare::compare(as_json(json_of_block(40)), as_json(json_of_block(42)), 0.001);
  const std::string words = compare::format_comparison(comparison, 0.001);
  EXPECT_TRUE(contains(words, "moved      front, top: whole views, by (0, -1) mm\n")) << words;
  EXPECT_TRUE(contains(words, "text       front: height '40' -> '42' at (")) << words;
  EXPECT_TRUE(contains(words, "2 differences above 0.001 mm: 1 moved, 1 text; ")) << words;
}

TEST(CompareJson, TellsLinesApart) {
  using Lines = std::vector<JsonLine>;
  EXPECT_EQ(changes_of_json([](Lines& l) { l.pop_back(); }), "removed");
  EXPECT_EQ(changes_of_json([](Lines& l) { l.push_back({{50, 10}, {60, 10}, true}); }), "added");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[3].visible = true; }), "visibility");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[0].kind = "smooth"; }), "restyled");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[0].kind = "tangent"; }), "restyled");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[0].kind = "section"; }), "");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[3].kind = "tangent"; }), "removed");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[3].from.x += 0.01; }), "moved");
  EXPECT_EQ(changes_of_json([](Lines& l) { l[0].to = {41, 10}; }), "added");
  const std::string face = R"(, "cut_faces": [{"model": 0, "body": 0, "rings": [[[10, 10], [40, 10], [10, 40]]]}])";
  EXPECT_EQ(changes(compare::compare(as_json(json_of(triangle)), as_json(json_of(triangle, "front", face)), 0.001)),
            "added added added");
}

// A drawing of one line of a kind, as people see it on a sheet and as it is in JSON.
TEST(CompareJson, SeesEdgesOfAllKindsAsSheetsDrawThem) {
  for (int i = 0; i <= static_cast<int>(EdgeKind::smooth); ++i)
    for (const bool seen : {true, false}) {
      const auto kind = static_cast<EdgeKind>(i);
      const std::vector<Vec2> points = {{10, 10}, {40, 10}};
      drawing::ViewDrawing drawing{};
      drawing.name = "front";
      drawing.segments = {{points[0], points[1], seen, kind, 0, {0, 1}, -1, {0, 1}}};
      drawing.chains = {{points, false, seen, kind, {0}}};
      const sheet::Paper paper = sheet::make_paper(scene::parse_paper_size("A4", "--sheet"), false);
      sheet::Sheet sheet{
          paper.width, paper.height, "one",
          sheet::view_layers(drawing, sheet::line_widths(paper), sheet::BodyStyles{{{sheet::BodyStyle()}}})};
      const compare::Picture drawn = compare::picture_of_svg(output::to_svg(sheet, {}), "test.svg");
      const compare::Picture read =
          compare::picture_of_json(output::to_json(sheet, 1, std::span(&drawing, 1), {}), "test.json");
      const auto look_of = [](const compare::Picture& picture) {
        if (picture.pieces.empty()) return std::tuple(0.0, false, std::vector<double>());
        const compare::PictureLook& look = picture.looks[static_cast<std::size_t>(picture.pieces[0].look)];
        return std::tuple(look.width, look.visible, look.dashes);
      };
      EXPECT_EQ(look_of(read), look_of(drawn)) << edges::name_of(kind) << seen;
      EXPECT_EQ(read.pieces.size(), drawn.pieces.size()) << edges::name_of(kind) << seen;
    }
}

TEST(CompareJson, RefusesWhatIsNoDrawing) {
  const auto refusal = [](const std::string& json) {
    return std::string(error_of([&] { compare::picture_of_json(json, "test.json"); }).what());
  };
  EXPECT_TRUE(contains(refusal("{"), "not valid JSON"));
  EXPECT_TRUE(contains(refusal("{}"), "has no 'epura'"));
  EXPECT_TRUE(contains(refusal(R"({"epura": 2})"), "schema"));
  std::string broken = json_of(triangle);
  broken.replace(broken.find("[12, 12]"), 8, "[12]");
  EXPECT_TRUE(contains(refusal(broken), "segments[3]: from is not a point")) << refusal(broken);
  EXPECT_TRUE(contains(refusal(std::string(100000, '[')), "not valid JSON"));
  error_of([] { compare::compare(as_json(json_of(triangle)), as_svg(plate()), 0.001); });
}

TEST(Compare, RefusesWhatItWouldNotSee) {
  const auto refusal = [](const std::string& svg) {
    return std::string(error_of([&] { compare::picture_of_svg(svg, "test.svg"); }).what());
  };
  const std::string head = "<svg width='10mm' height='10mm' viewBox='0 0 10 10'>";
  EXPECT_TRUE(contains(refusal(head + "<rect width='3' height='3'/></svg>"), "the element 'rect'"));
  EXPECT_TRUE(contains(refusal(head + "<path d='M 0 0 L 1'/></svg>"), "path"));
  EXPECT_TRUE(contains(refusal(head + "<path transform='skewX(3)' d='M 0 0'/></svg>"), "transform"));
  EXPECT_TRUE(contains(refusal("<svg width='10' viewBox='0 0 10 10'/>"), "size"));
  EXPECT_TRUE(contains(refusal("<svg"), "not valid XML"));
}

// Even if both are continuous and equally wide.
TEST(Looks, OfVisibleAndHiddenLinesDiffer) {
  compare::Picture visible{{100, 100}}, hidden{{100, 100}};
  visible.looks = {{.name = "visible", .visible = true, .width = 0.5}};
  hidden.looks = {{.name = "hidden", .visible = false, .width = 0.5}};
  EXPECT_EQ(compare::common_looks(visible, hidden).looks.size(), 2U);
  hidden.looks[0].visible = true;
  EXPECT_EQ(compare::common_looks(visible, hidden).looks.size(), 1U) << "names do not count";
}

}  // namespace
}  // namespace epura::test::compare_test
