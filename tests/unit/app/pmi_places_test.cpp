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

// Three sides of a target, beside the solid.
std::string sides() {
  return line(1200, "18.,12.,20.", true, "4.") + line(1210, "18.,18.,20.", true, "4.") +
         line(1220, "18.,12.,20.", false, "6.") +
         "#1230=SHAPE_REPRESENTATION('',(#1231),#30);\n#1231=GEOMETRIC_CURVE_SET('',(#1200,#1210,#1220));\n"
         "#1232=SHAPE_REPRESENTATION_RELATIONSHIP('','',#50,#1230);\n";
}

// A length between two of them; takes eight numbers.
std::string between(int number, int one, int other, const std::string& value) {
  const auto aspect = [](int at, int item) {
    return n(at) + "=SHAPE_ASPECT('','',#10,.T.);\n" + n(at + 1) + "=GEOMETRIC_ITEM_SPECIFIC_USAGE('',''," + n(at) +
           ",#1230," + n(item) + ");\n";
  };
  return aspect(number, one) + aspect(number + 2, other) + n(number + 4) +
         "=DIMENSIONAL_LOCATION('linear distance',''," + n(number) + "," + n(number + 2) + ");\n" +
         step_length(number + 5, value, "nominal value") + step_values(number + 6, number + 4, n(number + 5));
}

// Dimensions between the sides of a target say its size.
TEST_F(PmiPlaces, DimensionsBetweenLinesOnAFaceAreDrawn) {
  const std::string width = between(1300, 1200, 1210, "6."), length = between(1310, 1200, 1200, "4.");
  const Outcome drawn = draw_box(rectangle_target() + sides() + width + length, {"--frame", "none"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  for (const char* id : {"#1100", "#1304", "#1314"}) EXPECT_EQ(row(id)["view"].text, "top") << id;
  EXPECT_EQ(says("6"), 1);
  EXPECT_EQ(says("4"), 1);
  EXPECT_EQ(says("4×6"), 0);
  EXPECT_EQ(draw_box(rectangle_target()).code, 0);
  EXPECT_EQ(says("4×6"), 1);
  EXPECT_EQ(draw_box(sides() + between(1320, 1200, 1210, "7.")).code, 1);
  EXPECT_EQ(row("#1324")["reason"].text, "its lines have no distance of this length in one direction");
}

// Of two sides that meet, the one that is as long as required.
TEST_F(PmiPlaces, ADimensionOfSidesThatMeetIsTheLengthOfOne) {
  const std::string target = rectangle_target() + sides();
  for (const char* value : {"6.", "4."}) {
    const Outcome drawn = draw_box(target + between(1300, 1200, 1220, value), {"--frame", "none"});
    EXPECT_IMPORTER();
    EXPECT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(row("#1304")["view"].text, "top");
    EXPECT_EQ(says(std::string(value, 1)), 1) << value;
    EXPECT_EQ(says("4×6"), 1) << "one dimension does not say both";
  }
  EXPECT_EQ(draw_box(target + between(1300, 1200, 1220, "5.")).code, 1);
  EXPECT_EQ(row("#1304")["reason"].text, "its lines have no distance of this length in one direction");
}

// The words of a property.
std::string note_of(int number, int of, const std::string& text) {
  return n(number) + "=PROPERTY_DEFINITION('semantic text',''," + n(of) + ");\n" + n(number + 1) +
         "=PROPERTY_DEFINITION_REPRESENTATION(" + n(number) + "," + n(number + 2) + ");\n" + n(number + 2) +
         "=REPRESENTATION('',(" + n(number + 3) + "),#30);\n" + n(number + 3) +
         "=DESCRIPTIVE_REPRESENTATION_ITEM('','" + text + "');\n";
}

// One of the whole part is in the list of the sheet, one of a face has a leader.
TEST_F(PmiPlaces, NotesOfAFileAreOnTheSheet) {
  const Outcome drawn = draw_box(step_aspect(1000, top_face) + note_of(1010, 10, "BREAK EDGES\\X\\0AR0.5 MAX") +
                                 note_of(1020, 1000, "NO PAINT"));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("BREAK EDGES R0.5 MAX"), 1);
  EXPECT_EQ(says("NO PAINT"), 1);
  EXPECT_EQ(row("#1010")["kind"].text, "note");
  EXPECT_EQ(row("#1010")["view"].type, 'n');
  EXPECT_NE(row("#1010")["sheet"].type, 'n');
  EXPECT_NE(row("#1020")["view"].type, 'n');
}

// As some programs write it: the aspect is called a note. Of an edge, it stands where a view shows that as a point.
TEST_F(PmiPlaces, ANoteOfAnEdgeIsAtTheEdge) {
  std::string aspect = step_aspect(1000, step_box_edge(1, 5));
  aspect.replace(aspect.find("'',''"), 5, "'','NOTE'");
  std::string note = note_of(1010, 1000, "A");
  note.replace(note.find("semantic text"), 13, "");
  const std::string picture =
      "#1020=ANNOTATION_CURVE_OCCURRENCE('',(),#200);\n#1021=DRAUGHTING_CALLOUT('Text.1',(#1020));\n"
      "#1022=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#1000,#50,#1021);\n";
  const Outcome drawn = draw_box(aspect + note + picture, {"--frame", "none"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "all 1 requirements of the models are drawn")) << drawn.err;
  EXPECT_FALSE(contains(drawn.err, "without a meaning")) << drawn.err;
  EXPECT_EQ(says("A"), 1);
  EXPECT_EQ(row("#1010")["view"].text, "top");
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
