// SPDX-License-Identifier: Apache-2.0
// The axes of `epura lint`, its JSON, its picture, and what a scene accepts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"
#include "schema.hpp"

namespace epura::test::lint_axes_test {
namespace {

class LintAxes : public testing::Test {
 protected:
  // A block of 60 x 40 x 10 whose upper edge is cut off from (50, 10) to (60, 4).
  LintAxes() {
    folder_.file("block.obj",
                 "v 0 0 0\nv 60 0 0\nv 60 0 4\nv 50 0 10\nv 0 0 10\nv 0 40 0\nv 60 40 0\nv 60 40 4\nv 50 40 10\n"
                 "v 0 40 10\nf 1 2 3 4 5\nf 10 9 8 7 6\nf 1 6 7 2\nf 2 7 8 3\nf 3 8 9 4\nf 4 9 10 5\nf 5 10 6 1\n");
  }
  Outcome lint(const std::string& more, const std::vector<std::string>& options = {}) {
    folder_.file("a.toml",
                 "[[model]]\nfile = 'block.obj'\n[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'top'\n"
                 "[[sheet]]\nsize = 'A4'\nscale = '1:1'\n[[dimension]]\ntype = 'overall'\n" +
                     more);
    std::vector<std::string> words{"lint",  "a.toml",     "--json", "a.json", "--picture",
                                   "a.svg", "--svg-text", "text",   "--all"};
    words.insert(words.end(), options.begin(), options.end());
    return epura(words, folder_ / "");
  }
  [[nodiscard]] Json found() const { return JsonReader(read_file(folder_ / "a.json")).read(); }
  /// Findings of a kind about faces, as "7: can turn about y".
  [[nodiscard]] std::vector<std::string> of_faces(const char* kind) const {
    std::vector<std::string> list;
    const Json all = found();
    for (const Json& one : all["findings"].items)
      if (one["kind"].text == kind && one.keys().find("face") != std::string::npos)
        list.push_back(one["face"].text + one["what"].text.substr(one["what"].text.find("): ") + 1));
    return list;
  }
  /// Length of all lines of the hatching, mm: they rise at 45 degrees, so their widths tell it.
  [[nodiscard]] double red_ink() const {
    const std::string svg = read_file(folder_ / "a.svg");
    double sum = 0;
    for (std::size_t at = svg.find("-free\" inkscape"); at != std::string::npos;
         at = svg.find("-free\" inkscape", at + 1)) {
      const std::string group = svg.substr(at, svg.find("</g>", at) - at);
      for (std::size_t p = group.find('l', group.find(" d=\"M")); p != std::string::npos; p = group.find('l', p + 1))
        sum += std::sqrt(2) * std::abs(std::strtod(group.c_str() + p + 1, nullptr));
    }
    return sum;
  }

  Folder folder_;
};

/// The places of the ends of the slope; the text of the first one, if it is not the measured value.
std::string ends_of_slope(const std::string& text = "<>") {
  return "[[dimension]]\ntype = 'linear'\nview = 'front'\ndirection = 'horizontal'\nfrom = {point = [0, 0, 10]}\n"
         "to = {point = [50, 0, 10]}\ntext = '" +
         text +
         "'\n[[dimension]]\ntype = 'linear'\nview = 'front'\ndirection = 'vertical'\nfrom = {point = [60, 0, 0]}\n"
         "to = {point = [60, 0, 4]}\n";
}

std::string accepting(const std::string& feature) {
  return "[[accepted]]\nfeature = '" + feature + "'\nreason = 'as cast'\n";
}

void expect_refused(const Outcome& run, const std::string& words) {
  EXPECT_EQ(run.code, 2) << run.err;
  EXPECT_TRUE(contains(run.err, words)) << run.err;
}

TEST_F(LintAxes, AreToldEachApartAndAreAsTheSchemaSays) {
  const Outcome run = lint("");
  EXPECT_EQ(run.code, 1) << run.err;
  std::size_t last = 0;
  for (const char* axis : {"requirements", "completeness", "fidelity", "legibility", "restraint"}) {
    const std::size_t at = run.out.find("\n" + std::string(axis) + ": ");
    ASSERT_NE(at, std::string::npos) << axis << " in " << run.out;
    EXPECT_LT(last, at);
    last = at;
  }
  EXPECT_TRUE(contains(run.out, "fidelity: no fault\n")) << run.out;
  const Schema schema(read_file(root() / "src/run/app/lint.schema.json"));
  EXPECT_EQ(schema.fault_of(found()), "");
  Json without = found();
  without.names[0] = "lint";
  EXPECT_EQ(schema.fault_of(without), "value lacks epura_lint");
  EXPECT_GT(found()["axes"]["completeness"]["faults"].number(), 0);
  EXPECT_EQ(found()["axes"]["fidelity"]["faults"].number(), 0);
}

TEST_F(LintAxes, TellInWhichViewAFreeFaceCanBeHeld) {
  lint("");
  const std::vector<std::string> free = of_faces("not dimensioned");
  ASSERT_EQ(free.size(), 2U) << "the slope is free to move and to turn";
  for (const std::string& one : free) EXPECT_TRUE(one.ends_with(" in view 'front'")) << one;
}

// The block has 7 planes of three unknowns each; seven numbers are given, and six say how it lies in the world.
TEST_F(LintAxes, DependOnTheRulesThatReadersApply) {
  const Outcome run = lint(ends_of_slope(), {"--rules", "none"});
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_EQ(of_faces("not dimensioned").size(), 7U * 3 - 6 - 5) << run.out;
  EXPECT_EQ(lint(ends_of_slope(), {"--rules", "asme"}).code, 0);
  EXPECT_EQ(lint(ends_of_slope(), {"--rules", "parallel,perpendicular,in-line"}).code, 0);
  EXPECT_EQ(lint(ends_of_slope(), {"--rules", "perpendicular"}).code, 1);
  expect_refused(lint(ends_of_slope(), {"--rules", "parralel"}), "parallel");
}

TEST_F(LintAxes, OfRestraintHaveWhatFollowsFromWhat) {
  const std::string rest =
      "[[dimension]]\ntype = 'linear'\nview = 'front'\ndirection = 'horizontal'\nfrom = {point = [50, 0, 10]}\n"
      "to = {point = [60, 0, 4]}\n";
  const Outcome run = lint(ends_of_slope() + rest);
  EXPECT_EQ(run.code, 1) << run.out << run.err;
  EXPECT_EQ(found()["axes"]["restraint"]["faults"].number(), 2) << "10 along x is there twice: " << run.out;
  EXPECT_TRUE(contains(run.out, "follows from others: '10' in view 'front' follows from '60' and '50'; put"))
      << run.out;
  const Schema schema(read_file(root() / "src/run/app/lint.schema.json"));
  EXPECT_EQ(schema.fault_of(found()), "");
  const Outcome in_brackets = lint(ends_of_slope() + rest + "text = '(<>)'\n");
  EXPECT_EQ(in_brackets.code, 0) << in_brackets.out;
}

TEST_F(LintAxes, OfFidelityHasTextsThatAreUntrue) {
  const Outcome run = lint(ends_of_slope("51"));
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(found()["axes"]["fidelity"]["faults"].number(), 1) << run.out << run.err;
  EXPECT_EQ(found()["axes"]["completeness"]["faults"].number(), 0) << run.out;
  EXPECT_TRUE(contains(run.out, "fidelity: 1 fault\n")) << run.out;
}

// Two blocks on a plate, of which none is dimensioned by itself.
TEST_F(LintAxes, OfAssembliesJudgeTexts) {
  std::string obj;
  int first = 1;
  for (const auto& [name, low, high] :
       {std::tuple("plate", Vec3(0, 0, 0), Vec3(60, 40, 10)), std::tuple("post", Vec3(10, 10, 10), Vec3(18, 18, 40)),
        std::tuple("pin", Vec3(35, 25, 10), Vec3(43, 33, 40))}) {
    obj += std::string("o ") + name + "\n";
    for (const double z : {low.z, high.z})
      for (const double y : {low.y, high.y})
        for (const double x : {low.x, high.x})
          obj += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    for (const std::array<int, 4>& face : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                           std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
      obj += "f";
      for (const int corner : face) obj += " " + std::to_string(first + corner);
      obj += "\n";
    }
    first += 8;
  }
  folder_.file("assembly.obj", obj);
  const auto judged = [&](const std::string& rest) {
    return epura({"lint", folder_.file("assembly.toml",
                                       "views = ['front', 'top', 'left']\n[[model]]\nfile = "
                                       "'assembly.obj'\n[[dimension]]\ntype = 'auto'\n" +
                                           rest)},
                 folder_ / "");
  };
  EXPECT_TRUE(contains(judged("").out, "fidelity: no fault\n")) << judged("").out;
  const Outcome run = judged("[[dimension]]\nmatch = '25'\ntext = '26'\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "': the part has 25\n")) << run.out << run.err;
}

// At the point of a block, where no hole is.
TEST_F(LintAxes, OfNotesWithLeadersAreJudgedOrTold) {
  const std::string note = "[[note]]\nview = 'front'\nto = {point = [30, 0, 10]}\ntext = ";
  const Outcome run = lint(ends_of_slope() + note + "'⌀8 THRU'\n");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, "not judged: '⌀8 THRU' in view 'front'")) << run.out;
  EXPECT_TRUE(contains(run.out, "fidelity: no fault, 1 not judged\n")) << run.out;
  EXPECT_EQ(found()["axes"]["fidelity"]["undecided"].number(), 1);
  EXPECT_FALSE(contains(lint(ends_of_slope() + note + "'polished'\n").out, "not judged"));
}

TEST_F(LintAxes, OfACompleteDrawingHaveNoFault) {
  const Outcome run = lint(ends_of_slope());
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(red_ink(), 0);
}

// The view from above shows the slope, of 10 x 40; that from the front sees it edge-on.
TEST_F(LintAxes, HaveAPictureOfFreeFaces) {
  lint("");
  EXPECT_NEAR(red_ink() * 1.2, 400, 8);
  const std::string number = of_faces("not dimensioned").at(0).substr(0, 1);
  EXPECT_TRUE(contains(read_file(folder_ / "a.svg"), ">" + number + "<"));
}

TEST_F(LintAxes, LeaveOutWhatASceneAccepts) {
  lint("");
  const std::string number = of_faces("not dimensioned").at(0).substr(0, 1);
  const Outcome run = lint(accepting("face " + number));
  EXPECT_EQ(found()["axes"]["completeness"]["accepted"].number(), 2) << run.out;
  EXPECT_TRUE(contains(run.out, "(accepted: as cast)")) << run.out;
  EXPECT_EQ(red_ink(), 0);
  const Outcome unused = lint(ends_of_slope() + accepting("face 1"));
  EXPECT_EQ(unused.code, 0) << unused.out;
  EXPECT_TRUE(contains(unused.err, "nothing is found of the accepted face 1")) << unused.err;
  expect_refused(lint(accepting("face 99")), "has no face 99");
  expect_refused(lint("[[accepted]]\nfeature = 'face 1'\n"), "reason");
}

// The fourth one has its own.
TEST_F(LintAxes, CountANoteForAsManyHolesAsItSays) {
  folder_.file("part.obj", plate({40, 30}, 2, 2, 10, stepped_hole({{4, 10}, {4, 0}})));
  const std::string diameter = "[[dimension]]\ntype = 'diameter'\n";
  const std::string scene =
      folder_.file("scene.toml", "[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'top'\n" + diameter +
                                     "text = '3× <>'\nat = {point = [24, 15, 10]}\n" + diameter +
                                     "tolerance = 'H7'\nat = {point = [64, 45, 10]}\n");
  const Outcome run = epura({"lint", scene}, folder_ / "");
  EXPECT_FALSE(contains(run.out, "twice")) << run.out;
  EXPECT_FALSE(contains(run.out, "not dimensioned: hole ⌀8\n")) << run.out;
}

// With a counterbore of 12, 4 deep, above a bore of 8: at the rim of either.
TEST_F(LintAxes, OfNotesMayEndAtTheRecess) {
  folder_.file("part.obj", plate({40, 30}, 1, 1, 10, stepped_hole({{6, 10}, {6, 6}, {4, 6}, {4, 0}})));
  const auto judged = [&](double rim, const std::string& text) {
    const std::string at = "at = {point = [" + std::to_string(20 + rim) + ", 15, 10]}\n";
    const std::string scene = folder_.file("scene.toml",
                                           "[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'top'\n"
                                           "[[dimension]]\ntype = 'diameter'\ntext = '" +
                                               text + "'\n" + at);
    return epura({"lint", scene}, folder_ / "").out;
  };
  EXPECT_FALSE(contains(judged(6, "⌀8 ⌴⌀12 ↧4"), "untrue"));
  EXPECT_TRUE(contains(judged(6, "⌀9 ⌴⌀12 ↧4"), "untrue"));
  EXPECT_TRUE(contains(judged(6, "⌀8 ⌴⌀12 ↧5"), "untrue"));
}

// Two through bores of 4 beside two blind ones of 6.8, 8 deep, in which a thread is drawn: what is said of those of 4,
// or of all blind ones, is no word about the others.
TEST_F(LintAxes, OfGeneralNotesDenyNoOtherHoles) {
  const auto hole = [](const Vec2& centre) {
    const bool is_blind = centre.x < 40;
    return stepped_hole(is_blind ? std::vector<Vec2>{{3.4, 12}, {3.4, 4}} : std::vector<Vec2>{{2, 12}, {2, 0}})(centre);
  };
  folder_.file("part.obj", plate({40, 30}, 2, 2, 12, hole));
  const auto judged = [&](const std::string& text) {
    const std::string scene = folder_.file(
        "scene.toml",
        "views = ['front', 'top']\nmodel = [{file = 'part.obj'}]\ndimension = [{type = 'auto'}]\n"
        "thread = [{thread = 'M8', at = {point = [20, 15, 12]}, equal = true, depth = 8, callout = false}]\n"
        "note = [{text = '" +
            text + "'}]\n");
    return epura({"lint", scene}, folder_ / "").out;
  };
  for (const char* text : {"2 holes ⌀4", "Bohrungen ⌀4 durchgehend", "trous ⌀4 traversants", "All blind holes 8 deep"})
    EXPECT_FALSE(contains(judged(text), "untrue")) << text;
  for (const char* text : {"2 holes ⌀5", "All holes ⌀5"}) EXPECT_TRUE(contains(judged(text), "untrue")) << text;
}

/// A plate of 80 x 60 x 12 with two blind bores of 6.8, 8 deep, in which M8 is 6 deep, and two countersunk ones of 4.
class JudgedNotes : public LintAxes {
 protected:
  /// What is said of the notes, which are TOML.
  std::string lint_with(const std::string& notes) {
    const auto hole = [](const Vec2& centre) {
      return stepped_hole(centre.x < 40 ? std::vector<Vec2>{{3.4, 12}, {3.4, 4}}
                                        : std::vector<Vec2>{{4, 12}, {2, 10}, {2, 0}})(centre);
    };
    folder_.file("part.obj", plate({40, 30}, 2, 2, 12, hole));
    const std::string scene = folder_.file(
        "scene.toml",
        "views = ['front', 'top']\nmodel = [{file = 'part.obj'}]\n"
        "thread = [{thread = 'M8', at = {point = [20, 15, 12]}, equal = true, depth = 6, callout = false}]\n" +
            notes);
    const Outcome run = epura({"lint", scene}, folder_ / "");
    EXPECT_TRUE(contains(run.out, "fidelity: ")) << run.err;
    return run.out;
  }
  /// "untrue", "not judged", or nothing, of each text alone.
  std::string verdict(const std::string& text, const std::string& to = "") {
    std::string note = "[[note]]\ntext = '" + text + "'\n";
    if (!to.empty()) note += "view = 'top'\nto = " + to + "\n";
    const std::string told = lint_with(note);
    for (const std::string kind : {"untrue", "not judged"})
      if (contains(told, kind + ": '" + text)) return kind;
    return "";
  }
  void expect(const std::string& kind, const std::vector<std::string>& texts, const std::string& to = "") {
    for (const std::string& text : texts) EXPECT_EQ(verdict(text, to), kind) << text;
  }
};

TEST_F(JudgedNotes, OfThreadsKnowHowDeepTheyAre) {
  const std::string rim = "{point = [23.4, 15, 12]}", middle = "{point = [20, 15, 12]}";
  expect("", {"2× M8 ↧6/⌀6.8 ↧8", "M8 6 deep", "M8x1.25 - 6H"}, rim);
  expect("untrue", {"2× M8 ↧7/⌀6.8 ↧8", "M8 5 deep", "M8 THRU", "M8×1", "3× M8 ↧6"}, rim);
  expect("", {"M8 6 deep"}, middle);
  expect("untrue", {"M8 8 deep"}, middle);
}

TEST_F(JudgedNotes, AtNamedHolesAreOfTheirBores) {
  expect("", {"⌀4", "2× ⌀4 THRU"}, "'hole 4'");
  expect("untrue", {"⌀8", "3× ⌀4", "⌀4 ↧10"}, "'hole 4'");
}

TEST_F(JudgedNotes, WithoutLeadersAreOfThreadsLengthsAndThickness) {
  expect("",
         {"Plate 12 thick", "Dicke: 12 mm", "all threads M8", "2 Gewinde M8 ↧6", "Länge 80", "2× M8", "2 trous ⌀4"});
  expect("untrue", {"Plate 5 thick", "all ribs 3 thick", "all threads M6", "3 Gewinde M8", "2× M8 ↧8", "Länge 99",
                    "3 trous ⌀4", "alle Sacklöcher 7 tief"});
}

TEST_F(JudgedNotes, ThatNobodyUnderstandsAreTold) {
  expect("not judged",
         {"Mass 0.4 kg", "all ribs 12 thick", "Dicke 60", "60 between supports", "80 × 60 × 12", "80 x 80 x 12"});
  expect("", {"ISO 2768-mK", "deburred"});
}

// A flange of 4 holes, without and with the pitch circle, by a dimension and by a note.
TEST_F(LintAxes, OfPitchCirclesInTexts) {
  folder_.file("part.obj", flange(4, {15, 50, 36, 5}, 12));
  const auto judged = [&](const std::string& holes) {
    const std::string scene =
        folder_.file("scene.toml",
                     "view = [{projection = 'front', centre_lines = true}, {projection = 'top', centre_lines = true}]\n"
                     "model = [{file = 'part.obj'}]\n[[dimension]]\ntype = 'overall'\n"
                     "[[dimension]]\ntype = 'diameter'\nview = 'top'\nat = {point = [15, 0, 12]}\n" +
                         holes);
    return epura({"lint", scene, "--all"}, folder_ / "");
  };
  const std::string rim = "view = 'top'\nXX = {point = [30.455844122715711, 25.455844122715711, 12]}\n";
  const std::string dimension = "[[dimension]]\ntype = 'diameter'\n" + replaced(rim, "XX", "at") + "text = ";
  const std::string note = "[[note]]\n" + replaced(rim, "XX", "to") + "text = ";
  const Outcome without = judged(dimension + "'4× <>'\n");
  EXPECT_EQ(without.code, 1) << without.err;
  EXPECT_TRUE(contains(without.out, "pitch circle ⌀72")) << without.out;
  for (const std::string& holes : {dimension + "'4× <> ON ⌀72 BC'\n", note + "'4× ⌀10 auf Lochkreis 72'\n"}) {
    const Outcome run = judged(holes);
    EXPECT_EQ(run.code, 0) << holes << run.out << run.err;
  }
  EXPECT_TRUE(contains(judged(dimension + "'4× <> ON ⌀70 BC'\n").out, "untrue"));
}

}  // namespace
}  // namespace epura::test::lint_axes_test
