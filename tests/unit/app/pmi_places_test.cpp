// SPDX-License-Identifier: Apache-2.0
// Requirements that mean places beside faces: datum targets, lines on faces, notes; and the signs of two standards.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "step_box.hpp"

namespace epura::test::pmi_places_test {
namespace {

std::string n(int number) { return "#" + std::to_string(number); }

class PmiPlaces : public testing::Test {
 protected:
  Outcome draw(const std::string& model, std::vector<std::string> more = {}) {
    folder_.file("part.step", model);
    std::vector<std::string> words{"draw", "part.step", "--pmi", "all", "--views", "front,top,left", "--sheet",
                                   "A3",   "-o",        "a.svg", "-o",  "a.json",  "--svg-text",     "text"};
    words.insert(words.end(), more.begin(), more.end());
    Outcome drawn = epura(words, folder_ / "");
    has_importer_ = !contains(drawn.err, "install the package");
    return drawn;
  }
  Outcome draw_box(const std::string& statements, std::vector<std::string> more = {}) {
    return draw(step_box({40, 30, 20}, statements), std::move(more));
  }
  [[nodiscard]] int says(const std::string& text) const {
    const std::string svg = read_file(folder_ / "a.svg"), whole = ">" + text + "<";
    int count = 0;
    for (std::size_t at = svg.find(whole); at != std::string::npos; at = svg.find(whole, at + 1)) ++count;
    return count;
  }
  [[nodiscard]] Json row(const std::string& id) const {
    const Json ledger = JsonReader(read_file(folder_ / "a.json")).read()["report"]["requirements"];
    for (const Json& one : ledger.items)
      if (one["id"].text == id) return one;
    throw std::out_of_range("no requirement " + id);
  }

  Folder folder_;
  bool has_importer_ = false;
};

#define EXPECT_IMPORTER() \
  if (!has_importer_) GTEST_SKIP() << "there is no importer of STEP"

const std::string datum_of_targets =
    "#1190=DATUM('','',#10,.F.,'T');\n#1191=SHAPE_ASPECT_RELATIONSHIP('','',#1100,#1190);\n";

TEST_F(PmiPlaces, TargetsAreAreasInTheViewThatShowsThemTrue) {
  const std::string targets = step_target(1100, "1", {10, 10, 20}) + step_target(1120, "2", {30, 20, 20}) +
                              datum_of_targets + "#1192=SHAPE_ASPECT_RELATIONSHIP('','',#1120,#1190);\n";
  const Outcome drawn = draw_box(targets);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("T"), 1);
  EXPECT_EQ(says("T1"), 1);
  EXPECT_EQ(says("T2"), 1);
  EXPECT_EQ(says("⌀4"), 2);
  for (const char* id : {"#1100", "#1120"}) {
    EXPECT_EQ(row(id)["view"].text, "top");
    EXPECT_EQ(row(id)["reason"].type, 'n');
  }
  EXPECT_TRUE(contains(read_file(folder_ / "a.svg"), "top-targets"));
  EXPECT_EQ(draw_box(targets, {"--views", "isometric"}).code, 1);
  EXPECT_EQ(row("#1120")["reason"].text, "its datum T is not drawn");
  EXPECT_EQ(draw_box(targets, {"--views", "front"}).code, 0);
  EXPECT_EQ(row("#1120")["reason"].text, "as the letter of its datum: its place and size are not drawn");
}

// A line beside the solid, from a point along x or y; takes ten numbers.
std::string line(int number, const std::string& at, bool along_x, const std::string& length) {
  return n(number) + "=TRIMMED_CURVE(''," + n(number + 1) +
         ",(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);\n" + n(number + 1) + "=LINE(''," +
         n(number + 2) + "," + n(number + 3) + ");\n" + n(number + 2) + "=CARTESIAN_POINT('',(" + at + "));\n" +
         n(number + 3) + "=VECTOR(''," + n(number + 4) + "," + length + ");\n" + n(number + 4) + "=DIRECTION('',(" +
         (along_x ? "1.,0.,0." : "0.,1.,0.") + "));\n";
}

std::string rectangle_target() {
  std::string target = step_target(1100, "1", {20, 15, 20});
  target.replace(target.find("'circle'"), 8, "'rectangle'");
  target.replace(target.find("#1104,#1105"), 11, "#1104,#1105,#1110");
  target.replace(target.find("target diameter"), 15, "target length");
  return target + step_length(1110, "6.", "target width") + datum_of_targets;
}

// The sides of a target are lines beside the solid, and dimensions are between them: then they say its size.
TEST_F(PmiPlaces, DimensionsBetweenLinesOnAFaceAreDrawn) {
  const std::string sides =
      line(1200, "18.,12.,20.", true, "4.") + line(1210, "18.,18.,20.", true, "4.") +
      line(1220, "18.,12.,20.", false, "6.") +
      "#1230=SHAPE_REPRESENTATION('',(#1231),#30);\n#1231=GEOMETRIC_CURVE_SET('',(#1200,#1210,#1220));\n"
      "#1232=SHAPE_REPRESENTATION_RELATIONSHIP('','',#50,#1230);\n";
  const auto aspect = [](int number, int item) {
    return n(number) + "=SHAPE_ASPECT('','',#10,.T.);\n" + n(number + 1) + "=GEOMETRIC_ITEM_SPECIFIC_USAGE(''," +
           "''," + n(number) + ",#1230," + n(item) + ");\n";
  };
  const std::string width = aspect(1300, 1200) + aspect(1302, 1210) +
                            "#1304=DIMENSIONAL_LOCATION('linear distance','',#1300,#1302);\n" +
                            step_length(1305, "6.", "nominal value") + step_values(1306, 1304, "#1305");
  const std::string length = aspect(1310, 1200) + aspect(1312, 1200) +
                             "#1314=DIMENSIONAL_LOCATION('linear distance','',#1310,#1312);\n" +
                             step_length(1315, "4.", "nominal value") + step_values(1316, 1314, "#1315");
  const Outcome drawn = draw_box(rectangle_target() + sides + width + length, {"--frame", "none"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  for (const char* id : {"#1100", "#1304", "#1314"}) EXPECT_EQ(row(id)["view"].text, "top") << id;
  EXPECT_EQ(says("6"), 1);
  EXPECT_EQ(says("4"), 1);
  EXPECT_EQ(says("4×6"), 0);
  EXPECT_EQ(draw_box(rectangle_target()).code, 0);
  EXPECT_EQ(says("4×6"), 1);
  const std::string wrong = aspect(1320, 1200) + aspect(1322, 1210) +
                            "#1324=DIMENSIONAL_LOCATION('linear distance','',#1320,#1322);\n" +
                            step_length(1325, "7.", "nominal value") + step_values(1326, 1324, "#1325");
  EXPECT_EQ(draw_box(sides + wrong).code, 1);
  EXPECT_EQ(row("#1324")["reason"].text, "its lines have no distance of this length in one direction");
}

// What ISO says by a sign and ASME takes for granted, and the other way round.
TEST_F(PmiPlaces, SignsAreThoseOfTheStandard) {
  const std::string size = step_aspect(1000, round_face) + "#1002=DIMENSIONAL_SIZE(#1000,'diameter');\n" +
                           step_length(1003, "12.", "nominal value") +
                           "#1004=DESCRIPTIVE_REPRESENTATION_ITEM('','envelope requirement');\n"
                           "#1005=COMPOUND_REPRESENTATION_ITEM('',SET_REPRESENTATION_ITEM((#1004)));\n" +
                           step_values(1006, 1002, "#1003,#1005");
  const std::string profile = step_length(1100, "0.4", "") + step_length(1101, "0.3", "") +
                              step_aspect(1102, top_face) +
                              "#1104=(GEOMETRIC_TOLERANCE('','',#1100,#1102)SURFACE_PROFILE_TOLERANCE()"
                              "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE(#1101));\n";
  const Outcome iso = draw(step_shaft(6, 30, size + profile));
  EXPECT_IMPORTER();
  EXPECT_EQ(iso.code, 0) << iso.err;
  EXPECT_EQ(says("⌀12 (E)"), 1);
  EXPECT_EQ(says("UZ +0.1"), 1);
  EXPECT_EQ(draw(step_shaft(6, 30, size + profile), {"--standard", "ASME Y14.5-2018"}).code, 0);
  EXPECT_EQ(says("⌀12"), 1);
  EXPECT_EQ(says("U"), 1);
  EXPECT_EQ(says("0.3"), 1);
}

TEST_F(PmiPlaces, RepeatsHaveTheSignOfTheStandard) {
  const std::vector<std::string> words{
      "draw",  sample("bracket.obj"), "--views", "front,top,left", "--dimensions", "auto", "-o",
      "a.svg", "--svg-text",          "text"};
  EXPECT_EQ(epura(words, folder_ / "").code, 0);
  const std::string iso = read_file(folder_ / "a.svg");
  std::vector<std::string> more = words;
  more.insert(more.end(), {"--standard", "ASME Y14.5"});
  EXPECT_EQ(epura(more, folder_ / "").code, 0);
  const std::string asme = read_file(folder_ / "a.svg");
  EXPECT_TRUE(contains(iso, ">2× ") || contains(iso, ">4× "));
  EXPECT_FALSE(contains(iso, ">2X ") || contains(iso, ">4X "));
  EXPECT_TRUE(contains(asme, ">2X ") || contains(asme, ">4X "));
  EXPECT_FALSE(contains(asme, ">2× ") || contains(asme, ">4× "));
}

// Of the views that would show what is missing, the one that shows most.
TEST_F(PmiPlaces, AViewThatWouldShowThemIsProposed) {
  const auto flat = [](int number, int face) {
    return step_aspect(number, face) + step_length(number + 2, "0.05", "") + n(number + 3) +
           "=FLATNESS_TOLERANCE('',''," + n(number + 2) + "," + n(number) + ");\n";
  };
  const std::string hidden = step_target(1100, "1", {10, 10, 0}) + datum_of_targets;
  const Outcome drawn = draw_box(flat(1000, bottom_face) + hidden, {"--views", "isometric,top"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_EQ(row("#1003")["reason"].text, "no orthographic view of the sheet shows its faces: add the view 'front'");
  EXPECT_EQ(row("#1190")["reason"].text,
            "no orthographic view of the sheet shows a line of its faces: add the view 'front'");
}

}  // namespace
}  // namespace epura::test::pmi_places_test
