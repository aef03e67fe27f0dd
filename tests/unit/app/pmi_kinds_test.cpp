// SPDX-License-Identifier: Apache-2.0
// Requirements of every kind of face and edge on sheets: round ones, surface textures, projected zones; and the
// standard that a file names.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "step_box.hpp"

namespace epura::test::pmi_kinds_test {
namespace {

std::string n(int number) { return "#" + std::to_string(number); }

class PmiKinds : public testing::Test {
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

// A size of a face or an edge; takes eight numbers.
std::string size_of(int number, int item, const std::string& type, const std::string& value) {
  return step_aspect(number, item) + n(number + 2) + "=DIMENSIONAL_SIZE(" + n(number) + ",'" + type + "');\n" +
         step_length(number + 3, value, "nominal value") + step_values(number + 4, number + 2, n(number + 3));
}

std::string degrees(int number, const std::string& value) {
  return n(number) + "=(MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(" + value +
         "),#26)PLANE_ANGLE_MEASURE_WITH_UNIT()REPRESENTATION_ITEM('nominal value'));\n";
}

// Deviations of a dimension; takes four numbers.
std::string deviations(int number, int dimension, const std::string& by) {
  return step_length(number, "-" + by, "") + step_length(number + 1, by, "") + n(number + 2) + "=TOLERANCE_VALUE(" +
         n(number) + "," + n(number + 1) + ");\n" + n(number + 3) + "=PLUS_MINUS_TOLERANCE(" + n(number + 2) + "," +
         n(dimension) + ");\n";
}

// 12 wide below and 8 above, with outlines at 2 in 10: 22.62° between them.
TEST_F(PmiKinds, ConesHaveDiametersAndAngles) {
  const std::string angle = step_aspect(1030, round_face) + "#1032=ANGULAR_SIZE(#1030,'angle',.EQUAL.);\n" +
                            degrees(1033, "22.62") +
                            "#1034=VALUE_FORMAT_TYPE_QUALIFIER('NR2 2.2');\n"
                            "#1035=MEASURE_QUALIFICATION('','',#1033,(#1034));\n" +
                            step_values(1036, 1032, "#1033");
  const Outcome drawn =
      draw(step_frustum(6, 4, 10,
                        size_of(1000, round_face, "diameter", "12.") + size_of(1010, round_face, "diameter", "8.") +
                            size_of(1020, round_face, "radius", "4.") + angle));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  for (const char* text : {"⌀12", "⌀8", "R4", "22.62°"}) EXPECT_EQ(says(text), 1) << text;
  EXPECT_EQ(row("#1032")["view"].text, "front");
  EXPECT_EQ(draw(step_frustum(6, 4, 10, size_of(1000, round_face, "diameter", "11."))).code, 1);
  EXPECT_EQ(row("#1002")["reason"].text, "the model measures 12 at its faces");
}

// The angle of a cone to its axis, and between an axis and a plane.
TEST_F(PmiKinds, AnglesMayBeToAnAxis) {
  const std::string half = step_aspect(1030, round_face) + "#1032=ANGULAR_SIZE(#1030,'angle',.EQUAL.);\n" +
                           degrees(1033, "11.3099325") + step_values(1034, 1032, "#1033");
  const Outcome drawn = draw(step_frustum(6, 4, 10, half));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("11.3099325°"), 1);
}

TEST_F(PmiKinds, BallsAndRingsHaveTheirSizes) {
  const Outcome ball =
      draw(step_ball(10, size_of(1000, round_face, "spherical diameter", "20.") + deviations(1010, 1002, "0.1")));
  EXPECT_IMPORTER();
  EXPECT_EQ(ball.code, 0) << ball.err;
  EXPECT_EQ(says("S⌀20 ±0.1"), 1);
  // The tube has no circle in the views: it is told at a leader.
  const Outcome ring =
      draw(step_ball(3,
                     size_of(1000, round_face, "toroidal radius", "3.") + deviations(1010, 1002, "0.2") +
                         size_of(1020, round_face, "toroidal high major diameter", "26.") +
                         size_of(1030, round_face, "toroidal low major radius", "7."),
                     10));
  EXPECT_EQ(ring.code, 0) << ring.err;
  for (const char* text : {"R3 ±0.2", "⌀26", "R7"}) EXPECT_EQ(says(text), 1) << text;
  EXPECT_EQ(draw(step_ball(3, size_of(1000, round_face, "toroidal radius", "4."), 10)).code, 1);
}

// The circle of a shaft of 6 is 37.699 long; its roundness is that of the edge.
TEST_F(PmiKinds, RequirementsOfEdgesAreAtTheirEdges) {
  const std::string length = size_of(1000, 240, "curve length", "37.699") + deviations(1010, 1002, "0.5");
  const std::string roundness =
      step_aspect(1020, 241) + step_length(1022, "0.02", "") + "#1023=ROUNDNESS_TOLERANCE('','',#1022,#1020);\n";
  const std::string seam =
      step_aspect(1030, 242) + step_length(1032, "0.03", "") + "#1033=STRAIGHTNESS_TOLERANCE('','',#1032,#1030);\n";
  const Outcome drawn = draw(step_shaft(6, 30, length + roundness + seam));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("⌒37.699 ±0.5") + says("∩37.699 ±0.5"), 1);
  EXPECT_EQ(says("0.02"), 1);
  EXPECT_EQ(says("0.03"), 1);
}

// A tolerance of the only solid holds all over the part. A size of a solid means no face of it.
TEST_F(PmiKinds, AToleranceOfABodyIsAllOverIt) {
  constexpr int body = 52;
  const Outcome drawn = draw(step_box({40, 30, 20}, step_aspect(1000, body) + step_length(1002, "0.05", "") +
                                                        "#1003=SURFACE_PROFILE_TOLERANCE('','',#1002,#1000);\n" +
                                                        size_of(1010, body, "diameter", "12.")));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1);
  EXPECT_EQ(row("#1003")["sheet"].text, "1");
  EXPECT_EQ(says("all over"), 1);
  EXPECT_EQ(row("#1012")["reason"].text, "not read: 1 item without a face");
}

// Of one of several solids, at a leader to it.
TEST_F(PmiKinds, AToleranceOfOneBodyOfSeveralIsAtIt) {
  constexpr int body = 52;
  const Outcome drawn = draw(step_box({40, 30, 20}, step_aspect(1000, body) + step_length(1002, "0.05", "") +
                                                        "#1003=SURFACE_PROFILE_TOLERANCE('','',#1002,#1000);\n"
                                                        "#1004=MANIFOLD_SOLID_BREP('of another part',#53);\n"));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(row("#1003")["view"].type, 'n');
  EXPECT_EQ(says("all over"), 1);
  EXPECT_EQ(says("6× all over"), 0);
}

// As ISO 10303-1110 maps it, of an aspect or of the part (#10), with a parameter and its value; takes nine numbers.
std::string texture(int number, int of, const std::string& removal, const std::string& values) {
  const auto at = [number](int more) { return n(number + more); };
  return at(0) + "=PROPERTY_DEFINITION('surface texture',''," + n(of) + ");\n" + at(1) +
         "=PROPERTY_DEFINITION_REPRESENTATION(" + at(0) + "," + at(2) + ");\n" + at(2) +
         "=REPRESENTATION('surface texture',(" + at(3) + "),#30);\n" + at(3) +
         "=DESCRIPTIVE_REPRESENTATION_ITEM('material removal condition','" + removal + "');\n" + at(4) +
         "=PROPERTY_DEFINITION('surface_condition',''," + n(of) + ");\n" + at(5) +
         "=PROPERTY_DEFINITION_RELATIONSHIP('surface texture parameter',''," + at(0) + "," + at(4) + ");\n" + at(6) +
         "=PROPERTY_DEFINITION_REPRESENTATION(" + at(4) + "," + at(7) + ");\n" + at(7) +
         "=SURFACE_TEXTURE_REPRESENTATION('surface texture parameter',(" + at(8) + values + "),#30);\n" + at(8) +
         "=DESCRIPTIVE_REPRESENTATION_ITEM('measuring method','Ra');\n";
}

std::string micrometres(int number, const std::string& name, const std::string& value) {
  return n(number) + "=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(LENGTH_MEASURE(" +
         value + "),#1999)REPRESENTATION_ITEM('" + name + "'));\n";
}

const std::string micrometre = "#1999=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MICRO.,.METRE.));\n";

TEST_F(PmiKinds, SurfaceTexturesHaveTheirSymbols) {
  const std::string of_face = step_aspect(1000, top_face) + texture(1010, 1000, "material removal required", ",#1030") +
                              micrometres(1030, "characteristic value", "3.2") + micrometre;
  const std::string of_part = texture(1040, 10, "no material removal", ",#1060") +
                              "#1060=VALUE_RANGE('',(#1061,#1062));\n" + step_length(1061, "0.0125", "upper limit") +
                              step_length(1062, "0.0016", "lower limit");
  const Outcome drawn = draw(step_box({40, 30, 20}, of_face + of_part));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "all 2 requirements of the models are drawn")) << drawn.err;
  EXPECT_FALSE(contains(drawn.err, "not read")) << drawn.err;
  for (const char* text : {"Ra 3.2", "U Ra 12.5", "L Ra 1.6"}) EXPECT_EQ(says(text), 1) << text;
  EXPECT_EQ(row("#1010")["kind"].text, "surface texture");
  EXPECT_EQ(row("#1010")["what"].text, "surface texture Ra 3.2, material removal required");
  EXPECT_EQ(row("#1010")["view"].text, "front");
  EXPECT_EQ(row("#1040")["view"].type, 'n');
  EXPECT_EQ(row("#1040")["sheet"].text, "1");
  const Outcome form = epura({"requirements", "part.step", "--as9102", "-"}, folder_ / "");
  EXPECT_TRUE(contains(form.out, "\"surface texture Ra 3.2, material removal required\"")) << form.out;
}

// Several places have a symbol each; inches are microinches; what is not read is told.
TEST_F(PmiKinds, SurfaceTexturesAreWholeOrTold) {
  const std::string two =
      "#1000=SHAPE_ASPECT('','',#10,.T.);\n"
      "#1001=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1000,#50,#101);\n"
      "#1002=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1000,#50,#102);\n" +
      texture(1010, 1000, "any process allowed", ",#1030") + step_length(1030, "0.000063", "characteristic value");
  const Outcome drawn = draw(step_box({4, 3, 2}, two, true));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("Ra 63 µin"), 2);
  const std::string lost =
      "#1100=SURFACE_TEXTURE_REPRESENTATION('',(#1101),#30);\n"
      "#1101=DESCRIPTIVE_REPRESENTATION_ITEM('measuring method','Rz');\n";
  const std::string more = step_aspect(1200, top_face) + texture(1210, 1200, "any process allowed", ",#1230,#1231") +
                           step_length(1230, "0.0032", "characteristic value") +
                           step_length(1231, "4.", "evaluation length");
  EXPECT_EQ(draw(step_box({40, 30, 20}, lost + more)).code, 1);
  EXPECT_EQ(row("#1100")["reason"].text, "not read: a value, the surface that it belongs to");
  EXPECT_EQ(row("#1210")["reason"].text, "not read: 'evaluation length'");
}

// Beyond the part: ISO 10578.
TEST_F(PmiKinds, AProjectedZoneHasItsLength) {
  const std::string position =
      step_aspect(1000, round_face) + step_length(1002, "0.4", "") + step_length(1003, "12.5", "") +
      "#1004=(GEOMETRIC_TOLERANCE('','',#1002,#1000)POSITION_TOLERANCE());\n"
      "#1005=TOLERANCE_ZONE('','',#10,.F.,(#1004),#1006);\n#1006=TOLERANCE_ZONE_FORM('cylindrical or circular');\n"
      "#1007=PROJECTED_ZONE_DEFINITION(#1005,(),#1000,#1003);\n";
  const Outcome drawn = draw(step_shaft(6, 30, position));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  for (const char* text : {"⌀0.4", "P", "12.5"}) EXPECT_EQ(says(text), 1) << text;
  EXPECT_FALSE(contains(drawn.err, "PROJECTED_ZONE_DEFINITION")) << drawn.err;
  std::string other = position;
  other.replace(other.find("PROJECTED_ZONE_DEFINITION(#1005,(),#1000,#1003)"), 47,
                "NON_UNIFORM_ZONE_DEFINITION(#1005,())");
  EXPECT_EQ(draw(step_shaft(6, 30, other)).code, 1);
  EXPECT_EQ(row("#1004")["reason"].text, "not read: NON_UNIFORM_ZONE_DEFINITION");
}

TEST_F(PmiKinds, TheStandardOfTheFileIsThatOfTheSheet) {
  const std::string size = step_aspect(1000, bottom_face) + step_aspect(1002, top_face) +
                           "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                           step_length(1010, "20.", "nominal value") + step_values(1012, 1004, "#1010,#1014") +
                           "#1014=DESCRIPTIVE_REPRESENTATION_ITEM('dimensional note','independency');\n";
  const auto named = [](const std::string& id, const std::string& name, const std::string& role) {
    return "#1020=DOCUMENT('" + id + "','" + name +
           "','',#1021);\n#1021=DOCUMENT_TYPE('');\n"
           "#1022=APPLIED_DOCUMENT_REFERENCE(#1020,'',(#6));\n#1023=ROLE_ASSOCIATION(#1024,#1022);\n"
           "#1024=OBJECT_ROLE('mandatory','" +
           role + "');\n";
  };
  const Outcome drawn = draw(step_box({40, 30, 20}, size + named("ASME Y14.5-2018", "", "")));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("ASME Y14.5-2018"), 1);
  EXPECT_EQ(says("20 (I)"), 1);
  EXPECT_EQ(draw(step_box({40, 30, 20}, size + named("DIN 406", "", "dimensioning standard"))).code, 0);
  EXPECT_EQ(says("DIN 406"), 1);
  EXPECT_EQ(says("20"), 1);
  EXPECT_EQ(draw(step_box({40, 30, 20}, size + named("spec 7", "wiring", "design input"))).code, 0);
  EXPECT_EQ(says("spec 7"), 0);
  const std::vector<std::string> own{"--standard", "ISO 8015"};
  EXPECT_EQ(draw(step_box({40, 30, 20}, size + named("ASME Y14.5-2018", "", "")), own).code, 0);
  EXPECT_EQ(says("ISO 8015"), 1);
  EXPECT_EQ(says("ASME Y14.5-2018"), 0);
  EXPECT_EQ(says("20"), 1);
  EXPECT_TRUE(contains(epura({"info", "part.step"}, folder_ / "").out, "standard  ASME Y14.5-2018"));
  EXPECT_TRUE(contains(epura({"requirements", "part.step", "--json", "-"}, folder_ / "").out,
                       "\"standard\": \"ASME Y14.5-2018\""));
}

}  // namespace
}  // namespace epura::test::pmi_kinds_test
