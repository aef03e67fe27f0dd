// SPDX-License-Identifier: Apache-2.0
// Pairs of drawings made by hand, each with what a person would say of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "plate.hpp"
#include "sheet/lettering.hpp"

namespace epura::test::compare_pairs_test {
namespace {

struct Case {
  std::string name;
  std::string found;  ///< what changed and how often; empty: nothing
  std::function<void(sheet::Sheet&)> edit;
  double tolerance = 0.001;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

void to_layer(sheet::Sheet& sheet, std::size_t from, std::size_t number, std::size_t to) {
  sheet.layers[to].strokes.push_back(stroke(sheet, from, number));
  sheet.layers[from].strokes.erase(sheet.layers[from].strokes.begin() + std::ptrdiff_t(number));
}

// The outline as four strokes, the last one drawn backwards.
void cut_up(sheet::Sheet& sheet) {
  const std::vector<Vec2> points = stroke(sheet, visible, 0).points;
  sheet.layers[visible].strokes.erase(sheet.layers[visible].strokes.begin());
  for (std::size_t i = 0; i < 4; ++i) sheet.layers[visible].strokes.push_back(line(points[i], points[(i + 1) % 4]));
  std::reverse(sheet.layers[visible].strokes.back().points.begin(), sheet.layers[visible].strokes.back().points.end());
}

const std::vector<Case> same_lines = {
    {"Nothing", "", [](sheet::Sheet&) {}},
    {"StrokesInAnotherOrder", "", [](sheet::Sheet& s) { std::swap(stroke(s, visible, 0), stroke(s, visible, 2)); }},
    {"LayersInAnotherOrder", "", [](sheet::Sheet& s) { std::swap(s.layers[0], s.layers[1]); }},
    {"DrawnBackwards", "",
     [](sheet::Sheet& s) { std::reverse(stroke(s, hidden, 0).points.begin(), stroke(s, hidden, 0).points.end()); }},
    {"ClosedLineBegunElsewhere", "",
     [](sheet::Sheet& s) {
       std::vector<Vec2>& points = stroke(s, visible, 0).points;
       std::rotate(points.begin(), points.begin() + 2, points.end());
     }},
    {"ChainCutUp", "", cut_up},
    {"LineCutInTwo", "",
     [](sheet::Sheet& s) {
       stroke(s, hidden, 0).points[1] = {52, 60};
       s.layers[hidden].strokes.push_back(line({52, 60}, {90, 60}));
     }},
    {"PointInTheMiddle", "",
     [](sheet::Sheet& s) {
       stroke(s, hidden, 0).points.insert(stroke(s, hidden, 0).points.begin() + 1, {33, 60});
     }},
    {"DrawnTwice", "", [](sheet::Sheet& s) { s.layers[visible].strokes.push_back(stroke(s, visible, 2)); }},
    {"DrawnTwiceInPart", "",
     [](sheet::Sheet& s) {
       s.layers[visible].strokes.push_back(line({40, 50}, {70, 50}));
     }},
    {"HiddenUnderVisible", "",
     [](sheet::Sheet& s) {
       s.layers[hidden].strokes.push_back(line({20, 50}, {60, 50}));
     }},
};

const std::vector<Case> same_looks = {
    {"EdgesRenumbered", "",
     [](sheet::Sheet& s) {
       stroke(s, hidden, 0).edges = {{7, {8, 9}}};
     }},
    {"AnotherKindOfEdge", "", [](sheet::Sheet& s) { stroke(s, hidden, 0).kind = EdgeKind::contour; }},
    {"DashesFittedOtherwise", "",
     [](sheet::Sheet& s) {
       stroke(s, hidden, 0).dashes = {3.1, 0.8};
     }},
    {"DashesMetAtCrossings", "",
     [](sheet::Sheet& s) {
       stroke(s, hidden, 0).pattern = {3, 0.7, 5, 0.7, 50.6};
     }},
    {"ShortDashedLineContinuous", "", [](sheet::Sheet& s) { stroke(s, hidden, 1).dashes = {}; }},
    {"ViewRenamed", "", [](sheet::Sheet& s) { s.layers[visible].name = "another/visible"; }},
    {"StyleRenamed", "", [](sheet::Sheet& s) { s.layers[visible].style.name = "section"; }},
    {"LayerSplit", "",
     [](sheet::Sheet& s) {
       s.layers.push_back({"front/visible2", s.layers[visible].style, {}});
       to_layer(s, visible, 0, 4);
     }},
};

const std::vector<Case> within_the_tolerance = {
    {"MovedByLessThanTheTolerance", "",
     [](sheet::Sheet& s) {
       move(stroke(s, hidden, 0), {0, 0.0005});
     }},
    {"ShorterByLessThanTheTolerance", "", [](sheet::Sheet& s) { stroke(s, hidden, 0).points[0].x += 0.0008; }},
    {"GapBelowTheTolerance", "",
     [](sheet::Sheet& s) {
       stroke(s, hidden, 0).points[1] = {52, 60};
       s.layers[hidden].strokes.push_back(line({52.0008, 60}, {90, 60}));
     }},
    {"CircleInTwoParts", "",
     [](sheet::Sheet& s) {
       sheet::Stroke& whole = stroke(s, visible, 1);
       std::rotate(whole.points.begin(), whole.points.begin() + 9, whole.points.end());
       whole.curves[0].from += std::numbers::pi / 2;
       whole.curves[0].to += std::numbers::pi / 2;
     }},
    {"PolygonWithinTheTolerance", "", [](sheet::Sheet& s) { stroke(s, visible, 1).curves.clear(); }, 0.05},
    {"HiddenBesideVisible", "",
     [](sheet::Sheet& s) {
       s.layers[hidden].strokes.push_back(line({20, 50.0007}, {60, 50.0007}));
     }},
    {"EndOfSeveralPiecesShorterByLessThanTheTolerance", "",
     [](sheet::Sheet& s) {
       s.layers[hidden].strokes.push_back(line({90, 60}, {90.1, 60}));
       s.layers[hidden].strokes.push_back(line({90.1, 60}, {90.2, 60}));
     },
     0.3},
    {"TickAcrossALineWithinTheTolerance", "",
     [](sheet::Sheet& s) {
       s.layers[hidden].strokes.push_back(line({70, 59.9}, {70, 60.1}));
     },
     0.3},
    {"EverythingMovedWithinTheTolerance", "",
     [](sheet::Sheet& s) {
       for (sheet::Layer& layer : s.layers)
         for (sheet::Stroke& each : layer.strokes) move(each, {0.2, 0.3});
     },
     0.5},
    {"TextFromItsOtherEnd", "",
     [](sheet::Sheet& s) {
       sheet::Text& words = s.layers[dimension].texts[0];
       words.align = sheet::Align::left;
       words.at.x -= 0.5 * sheet::Lettering().width(words.text, words.height);
     }},
};

const std::vector<Case> different_lines = {
    {"LineRemoved", "removed", [](sheet::Sheet& s) { s.layers[hidden].strokes.pop_back(); }},
    {"HiddenBesideVisibleAddedAboveTheTolerance", "added",
     [](sheet::Sheet& s) {
       s.layers[hidden].strokes.push_back(line({20, 50.01}, {60, 50.01}));
     }},
    {"LineAdded", "added",
     [](sheet::Sheet& s) {
       s.layers[visible].strokes.push_back(line({30, 45}, {40, 47}));
     }},
    {"CircleRemoved", "removed",
     [](sheet::Sheet& s) { s.layers[visible].strokes.erase(s.layers[visible].strokes.begin() + 1); }},
    {"OutlineOpened", "removed", [](sheet::Sheet& s) { stroke(s, visible, 0).closed = false; }},
    {"LineLonger", "added", [](sheet::Sheet& s) { stroke(s, hidden, 0).points[1].x = 92; }},
    {"LineShorter", "removed", [](sheet::Sheet& s) { stroke(s, hidden, 0).points[1].x = 89.9; }},
    {"GapInALine", "removed",
     [](sheet::Sheet& s) {
       stroke(s, visible, 2).points[1] = {52, 50};
       s.layers[visible].strokes.push_back(line({52.01, 50}, {100, 50}));
     }},
    {"LineMoved", "moved",
     [](sheet::Sheet& s) {
       move(stroke(s, visible, 2), {0, 0.3});
     }},
    {"LineMovedAboveTheTolerance", "moved",
     [](sheet::Sheet& s) {
       move(stroke(s, visible, 2), {0, 0.6});
     },
     0.5},
    {"LineOfAnEdgeMovedFar", "moved",
     [](sheet::Sheet& s) {
       move(stroke(s, visible, 2), {3, 12});
     }},
    {"LineMovedFar", "removed added",
     [](sheet::Sheet& s) {
       stroke(s, visible, 2) = line({20, 62}, {100, 62});
     }},
    {"LineTurned", "removed added", [](sheet::Sheet& s) { stroke(s, dimension, 0).points[1].y += 0.5; }},
};

const std::vector<Case> different_curves_and_looks = {
    {"CircleMoved", "moved",
     [](sheet::Sheet& s) {
       move(stroke(s, visible, 1), {1, 1});
     }},
    {"CircleLarger", "removed added",
     [](sheet::Sheet& s) {
       stroke(s, visible, 1) = circle({60, 80}, 5.1);
     }},
    {"PolygonForACircle", "removed added", [](sheet::Sheet& s) { stroke(s, visible, 1).curves.clear(); }},
    {"VisibleBecameHidden", "visibility", [](sheet::Sheet& s) { to_layer(s, visible, 2, hidden); }},
    {"HiddenBecameVisible", "visibility", [](sheet::Sheet& s) { to_layer(s, hidden, 0, visible); }},
    {"PartBecameHidden", "visibility",
     [](sheet::Sheet& s) {
       stroke(s, visible, 2).points[1] = {70, 50};
       s.layers[hidden].strokes.push_back(line({70, 50}, {100, 50}));
     }},
    {"LineWider", "restyled", [](sheet::Sheet& s) { s.layers[dimension].style.width = 0.35; }},
    {"DashesOfOneLineInAContinuousStyle", "restyled",
     [](sheet::Sheet& s) {
       stroke(s, dimension, 0).dashes = {5, 0.75, 0.125, 1};
     }},
    {"LineDashed", "restyled",
     [](sheet::Sheet& s) {
       s.layers[dimension].style.dashes = {6, 1.5};
     }},
    {"AnotherDashPattern", "restyled restyled",
     [](sheet::Sheet& s) {
       s.layers[hidden].style.dashes = {6, 0.75, 0.125, 1};
     }},
};

const std::vector<Case> different_areas_and_texts = {
    {"ArrowRemoved", "removed removed removed", [](sheet::Sheet& s) { s.layers[dimension].fills.clear(); }},
    {"ArrowOfAnotherSize", "removed removed added added moved",
     [](sheet::Sheet& s) {
       s.layers[dimension].fills[0].rings[0] = {{20, 30}, {24, 29.4}, {24, 30.6}};
     }},
    {"TextChanged", "text", [](sheet::Sheet& s) { s.layers[dimension].texts[0].text = "81"; }},
    {"TextMoved", "moved", [](sheet::Sheet& s) { s.layers[dimension].texts[0].at.x += 0.7; }},
    {"TextRemoved", "removed", [](sheet::Sheet& s) { s.layers[text].texts.pop_back(); }},
    {"TextAdded", "added",
     [](sheet::Sheet& s) {
       s.layers[text].texts.push_back({"A-A", {60, 120}, 5});
     }},
    {"TextLarger", "restyled", [](sheet::Sheet& s) { s.layers[text].texts[0].height = 7; }},
    {"SheetLarger", "size", [](sheet::Sheet& s) { s.width = 220; }},
    {"LineRemovedAndTextChanged", "removed text",
     [](sheet::Sheet& s) {
       s.layers[hidden].strokes.pop_back();
       s.layers[text].texts[0].text = "Plane";
     }},
};

class Pair : public testing::TestWithParam<Case> {};

TEST_P(Pair, IsJudgedAsAPersonWould) {
  sheet::Sheet edited = plate();
  GetParam().edit(edited);
  const compare::Comparison comparison = compare::compare(as_svg(plate()), as_svg(edited), GetParam().tolerance);
  EXPECT_EQ(changes(comparison), GetParam().found) << compare::format_comparison(comparison, GetParam().tolerance);
  const compare::Comparison turned = compare::compare(as_svg(edited), as_svg(plate()), GetParam().tolerance);
  EXPECT_EQ(turned.differences.empty(), comparison.differences.empty())
      << compare::format_comparison(turned, GetParam().tolerance);
}

std::string name_of_case(const testing::TestParamInfo<Case>& of) { return of.param.name; }

INSTANTIATE_TEST_SUITE_P(SameLines, Pair, testing::ValuesIn(same_lines), name_of_case);
INSTANTIATE_TEST_SUITE_P(SameLooks, Pair, testing::ValuesIn(same_looks), name_of_case);
INSTANTIATE_TEST_SUITE_P(WithinTheTolerance, Pair, testing::ValuesIn(within_the_tolerance), name_of_case);
INSTANTIATE_TEST_SUITE_P(DifferentLines, Pair, testing::ValuesIn(different_lines), name_of_case);
INSTANTIATE_TEST_SUITE_P(DifferentCurvesAndLooks, Pair, testing::ValuesIn(different_curves_and_looks), name_of_case);
INSTANTIATE_TEST_SUITE_P(DifferentAreasAndTexts, Pair, testing::ValuesIn(different_areas_and_texts), name_of_case);

}  // namespace
}  // namespace epura::test::compare_pairs_test
