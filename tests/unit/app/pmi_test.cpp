// SPDX-License-Identifier: Apache-2.0
// Requirements of model files on sheets, and the ledger in which nothing is lost.
#include <gtest/gtest.h>

#include <chrono>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "schema.hpp"
#include "step_box.hpp"

namespace epura::test::pmi_test {
namespace {

// A value of a dimension with digits: "20.00".
std::string size(int number, int dimension, const std::string& value, const std::string& digits) {
  const std::string item = std::to_string(number), format = std::to_string(number + 1);
  return step_length(number, value, "nominal value", "QUALIFIED_REPRESENTATION_ITEM((#" + format + "))") + "#" +
         format + "=VALUE_FORMAT_TYPE_QUALIFIER('NR2 " + digits + "');\n" +
         step_values(number + 2, dimension, "#" + item);
}

std::string deviations(int number, int dimension, const std::string& lower, const std::string& upper) {
  const auto n = [number](int more) { return std::to_string(number + more); };
  return step_length(number, lower, "") + step_length(number + 1, upper, "") + "#" + n(2) + "=TOLERANCE_VALUE(#" +
         n(0) + ",#" + n(1) + ");\n#" + n(3) + "=PLUS_MINUS_TOLERANCE(#" + n(2) + ",#" + std::to_string(dimension) +
         ");\n";
}

// A datum that is a face of the box; takes three numbers.
std::string datum(int number, int face, const std::string& letter) {
  const auto n = [number](int more) { return std::to_string(number + more); };
  return step_aspect(number, face, "DATUM_FEATURE") + "#" + n(2) + "=DATUM('','',#10,.F.,'" + letter + "');\n#" + n(3) +
         "=SHAPE_ASPECT_RELATIONSHIP('','',#" + n(0) + ",#" + n(2) + ");\n";
}

// Height of 20.00 -0.1/+0.3 between bottom and top.
const std::string height = step_aspect(1000, bottom_face) + step_aspect(1002, top_face) +
                           "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                           size(1010, 1004, "20.", "2.2") + deviations(1014, 1004, "-0.1", "0.3");

class Pmi : public testing::Test {
 protected:
  // Draws a model as SVG and JSON.
  Outcome draw(const std::string& model, std::vector<std::string> more = {}) {
    folder_.file("part.step", model);
    std::vector<std::string> words{"draw", "part.step", "--views", "front,top,left", "--sheet",    "A3",
                                   "-o",   "a.svg",     "-o",      "a.json",         "--svg-text", "text"};
    words.insert(words.end(), more.begin(), more.end());
    Outcome drawn = epura(words, folder_ / "");
    has_importer_ = !contains(drawn.err, "install the package");
    return drawn;
  }
  Outcome draw_box(const std::string& statements, std::vector<std::string> more = {"--pmi", "all"}, bool inch = false) {
    return draw(step_box({40, 30, 20}, statements, inch), std::move(more));
  }
  // How often the sheet says it.
  [[nodiscard]] int says(const std::string& text) const {
    const std::string svg = read_file(folder_ / "a.svg"), whole = ">" + text + "<";
    int count = 0;
    for (std::size_t at = svg.find(whole); at != std::string::npos; at = svg.find(whole, at + 1)) ++count;
    return count;
  }
  [[nodiscard]] Json ledger() const {
    return JsonReader(read_file(folder_ / "a.json")).read()["report"]["requirements"];
  }
  [[nodiscard]] Json row(const std::string& id) const {
    for (const Json& one : ledger().items)
      if (one["id"].text == id) return one;
    throw std::out_of_range("no requirement " + id);
  }

  Folder folder_;
  bool has_importer_ = true;
};

#define EXPECT_IMPORTER() \
  if (!has_importer_) GTEST_SKIP() << "there is no importer of STEP"

TEST_F(Pmi, ADimensionHasTheDigitsAndDeviationsOfItsFile) {
  const Outcome drawn = draw_box(height);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "all 1 requirements of the models are drawn")) << drawn.err;
  EXPECT_EQ(says("20.00 "), 1);
  EXPECT_EQ(says("+0.3"), 1);
  EXPECT_EQ(says("-0.1"), 1);
  EXPECT_EQ(row("#1004")["view"].text, "front");
  EXPECT_EQ(row("#1004")["reason"].type, 'n');
}

// Sheets with a frame have fields, those without have none.
TEST_F(Pmi, TheLedgerSaysInWhichFieldOfTheFrameTheyAre) {
  const std::string flatness = step_length(1020, "0.05", "") + "#1021=FLATNESS_TOLERANCE('','',#1020,#1002);\n";
  const Outcome drawn = draw_box(height + flatness);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  for (const char* id : {"#1004", "#1021"}) {
    EXPECT_EQ(row(id)["sheet_zone"].text.size(), 2U) << row(id)["sheet_zone"].text;
    EXPECT_EQ(row(id)["characteristic"].text, std::string(id) == "#1004" ? "1" : "2");
  }
  const std::string zone = row("#1004")["sheet_zone"].text;
  const std::vector<std::string> list{"requirements", "part.step", "--drawing", "a.json",
                                      "--as9102",     "form.csv",  "--json",    "l.json"};
  EXPECT_EQ(epura(list, folder_ / "").code, 0);
  EXPECT_TRUE(contains(read_file(folder_ / "form.csv"),
                       "1,\"sheet 1, zone " + zone + ", view front\",,linear distance 20.00 -0.1/+0.3 mm,,,,\r\n"))
      << read_file(folder_ / "form.csv");
  const Json listed = JsonReader(read_file(folder_ / "l.json")).read()["models"].items.at(0)["requirements"];
  EXPECT_EQ(listed.items.at(0)["sheet_zone"].text, zone);
  EXPECT_EQ(draw_box(height, {"--pmi", "all", "--frame", "none"}).code, 0);
  EXPECT_EQ(row("#1004")["sheet_zone"].type, 'n');
  folder_.file("part.step", step_box({40, 30, 20}, height + flatness));
  const Outcome other = epura(list, folder_ / "");
  EXPECT_EQ(other.code, 2) << other.err;
  EXPECT_TRUE(contains(other.err, "the drawing does not have requirement #1021, flatness 0.05 mm")) << other.err;
}

TEST_F(Pmi, AnAutomaticDimensionOfTheSameIsOneWithIt) {
  const Outcome drawn = draw_box(height, {"--dimensions", "auto"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("20.00 "), 1);
  EXPECT_EQ(says("20"), 0);
  EXPECT_EQ(says("40"), 1);
  EXPECT_EQ(says("30"), 1);
}

TEST_F(Pmi, ADimensionThatIsStatedTwiceIsDrawnOnce) {
  const std::string again = "#1104=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                            size(1110, 1104, "20.", "2.2") + deviations(1114, 1104, "-0.1", "0.3");
  const std::string wider = "#1204=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                            size(1210, 1204, "20.", "2.2") + deviations(1214, 1204, "-0.4", "0.3");
  const Outcome drawn = draw_box(height + again + wider);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("20.00 "), 2);
  EXPECT_EQ(says("-0.1"), 1);
  EXPECT_EQ(says("-0.4"), 1);
  EXPECT_EQ(row("#1104")["view"].text, "front");
  EXPECT_EQ(row("#1104")["sheet_zone"].text, row("#1004")["sheet_zone"].text);
}

TEST_F(Pmi, PicturesHaveNoneUnlessAsked) {
  const Outcome drawn = draw_box(height, {});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0);
  EXPECT_TRUE(contains(drawn.err, "1 dimension of the file is not drawn")) << drawn.err;
  EXPECT_EQ(says("20.00 "), 0);
  EXPECT_EQ(row("#1004")["wanted"].type, 'f');
  EXPECT_EQ(draw_box(height, {"--dimensions", "auto", "--pmi", "none"}).code, 0);
  EXPECT_EQ(says("20"), 1);
}

TEST_F(Pmi, LimitsFitsAndInchesAreWrittenAsInTheFile) {
  const std::string width = step_aspect(1100, left_face) + step_aspect(1102, right_face) +
                            "#1104=DIMENSIONAL_LOCATION('linear distance','',#1100,#1102);\n" +
                            step_length(1105, "39.5", "lower limit") + step_length(1106, "40.25", "upper limit") +
                            step_values(1107, 1104, "#1105,#1106");
  const Outcome drawn = draw_box(width);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("39.50"), 1);
  EXPECT_EQ(says("40.25"), 1);
  EXPECT_EQ(draw_box(height, {"--pmi", "all", "--scale", "1:20"}, true).code, 0);
  EXPECT_EQ(says("20.00 "), 1);
  EXPECT_EQ(draw_box(height, {"--pmi", "all", "--scale", "1:20", "--dimension-unit", "mm"}, true).code, 0);
  EXPECT_EQ(says(" in"), 1);
  const std::string fit = "#1030=SHAPE_ASPECT('','',#10,.T.);\n" + step_aspect(1040, round_face) +
                          "#1042=DIMENSIONAL_SIZE(#1040,'diameter');\n" + size(1050, 1042, "12.", "2.1") +
                          "#1060=LIMITS_AND_FITS('h','shaft','6','');\n#1061=PLUS_MINUS_TOLERANCE(#1060,#1042);\n";
  EXPECT_EQ(draw(step_shaft(6, 30, fit), {"--pmi", "all"}).code, 0);
  EXPECT_EQ(says("⌀12.0 h6"), 1);
}

// A tolerance of each kind on the top, with zones from 0.0101 on, to the datum T.
TEST_F(Pmi, EveryCharacteristicHasItsFrame) {
  const std::vector<std::string> plain{"FLATNESS",     "STRAIGHTNESS", "ROUNDNESS",
                                       "CYLINDRICITY", "LINE_PROFILE", "SURFACE_PROFILE"};
  const std::vector<std::string> related{"PARALLELISM", "PERPENDICULARITY", "ANGULARITY",
                                         "POSITION",    "CONCENTRICITY",    "COAXIALITY",
                                         "SYMMETRY",    "CIRCULAR_RUNOUT",  "TOTAL_RUNOUT"};
  std::string text =
      step_aspect(1000, top_face) + datum(1100, bottom_face, "T") +
      "#1110=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,#1102,$);\n#1111=DATUM_SYSTEM('','',#10,.F.,(#1110));\n";
  int number = 1200, zone = 101;
  std::vector<std::string> ids;
  const auto add = [&](const std::string& name, const std::string& datums) {
    const std::string n = std::to_string(number), value = std::to_string(number + 1);
    text += step_length(number + 1, "0.0" + std::to_string(zone++), "") + "#" + n + "=" + name + "_TOLERANCE('','',#" +
            value + ",#1000" + datums + ");\n";
    ids.push_back("#" + n);
    number += 2;
  };
  for (const std::string& name : plain) add(name, "");
  for (const std::string& name : related) add(name, ",(#1111)");
  const Outcome drawn = draw_box(text, {"--pmi", "all", "--sheet", "A2"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  for (int width = 101; width < zone; ++width)
    EXPECT_EQ(says(std::string(width == 110 ? "0.011" : "0.0" + std::to_string(width))), 1) << width << drawn.err;
  EXPECT_EQ(says("T"), 1 + static_cast<int>(related.size()));
  for (const std::string& id : ids) EXPECT_NE(row(id)["view"].type, 'n') << id;
}

TEST_F(Pmi, WhatHasNoFaceOrDisagreesIsToldAndNotDrawn) {
  const std::string dangling =
      "#1030=SHAPE_ASPECT('','',#10,.T.);\n#1031=DIMENSIONAL_SIZE(#1030,'diameter');\n" + size(1040, 1031, "8.", "2.1");
  const std::string wrong = step_aspect(1100, left_face) + step_aspect(1102, right_face) +
                            "#1104=DIMENSIONAL_LOCATION('linear distance','',#1100,#1102);\n" +
                            size(1110, 1104, "41.", "2.1");
  const Outcome drawn = draw_box(height + dangling + wrong);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "2 of the 3 requirements of the models are not drawn:")) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "#1104 linear distance 41.0 mm: the model measures 40 at its faces")) << drawn.err;
  EXPECT_EQ(row("#1031")["view"].type, 'n');
  EXPECT_EQ(row("#1031")["reason"].text, "not read: a face that it belongs to");
  EXPECT_EQ(says("41.0"), 0);
  EXPECT_EQ(draw_box(height + dangling, {"--pmi", "all", "--allow-missing-requirements"}).code, 0);
}

// A frame of two rows with one symbol, and the signs of a zone, its modifier and the datums.
TEST_F(Pmi, ACompositeToleranceIsOneFrame) {
  const std::string position =
      datum(1100, bottom_face, "T") + step_aspect(1000, round_face) + step_length(1002, "0.4", "") +
      step_length(1003, "0.15", "") +
      "#1110=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,#1102,$);\n#1111=DATUM_SYSTEM('','',#10,.F.,(#1110));\n"
      "#1124=(GEOMETRIC_TOLERANCE('','',#1002,#1000)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#1111))"
      "GEOMETRIC_TOLERANCE_WITH_MODIFIERS((.MAXIMUM_MATERIAL_REQUIREMENT.))POSITION_TOLERANCE());\n"
      "#1125=(GEOMETRIC_TOLERANCE('','',#1003,#1000)POSITION_TOLERANCE());\n"
      "#1126=GEOMETRIC_TOLERANCE_RELATIONSHIP('composite tolerance','',#1124,#1125);\n"
      "#1130=TOLERANCE_ZONE('','',#10,.F.,(#1124,#1125),#1131);\n#1131=TOLERANCE_ZONE_FORM('cylindrical or "
      "circular');\n";
  const std::string size = "#1042=DIMENSIONAL_SIZE(#1000,'diameter');\n" + pmi_test::size(1050, 1042, "12.", "2.2");
  const Outcome drawn = draw(step_shaft(6, 30, position + size), {"--pmi", "all"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("⌀12.00"), 1);
  EXPECT_EQ(says("⌀0.4"), 1);
  EXPECT_EQ(says("⌀0.15"), 1);
  EXPECT_EQ(says("M"), 1);
  EXPECT_EQ(says("T"), 2);
  EXPECT_EQ(row("#1125")["view"].text, "front");
}

TEST_F(Pmi, ADistanceOfEdgesIsDrawn) {
  const Outcome drawn = draw_box(step_aspect(1000, step_box_edge(4, 6)) + step_aspect(1002, step_box_edge(5, 7)) +
                                 "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                                 size(1010, 1004, "40.", "2.2") + deviations(1014, 1004, "-0.1", "0.3"));
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("40.00 "), 1);
}

TEST_F(Pmi, ASheetWithoutRoomLosesNothingInSilence) {
  std::string text;
  for (int i = 0; i < 12; ++i)
    text += step_aspect(1100 + 10 * i, left_face + i % 6) +
            step_length(1102 + 10 * i, "0.0" + std::to_string(21 + i), "") + "#" + std::to_string(1103 + 10 * i) + "=" +
            (i < 6 ? "FLATNESS" : "STRAIGHTNESS") + "_TOLERANCE('','',#" + std::to_string(1102 + 10 * i) + ",#" +
            std::to_string(1100 + 10 * i) + ");\n";
  const Outcome drawn = draw_box(text, {"--pmi", "all", "--sheet", "150x110", "--scale", "1:1"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  int shown = 0, told = 0;
  for (const Json& one : ledger().items) {
    const bool is_shown = one["view"].type != 'n';
    shown += is_shown ? says(one["what"].text.substr(one["what"].text.find("0.0"), 5)) : 0;
    told += !is_shown && contains(drawn.err, one["id"].text + " " + one["what"].text) ? 1 : 0;
  }
  EXPECT_GT(told, 0);
  EXPECT_EQ(shown + told, 12) << drawn.err;
}

// Lengths that differ by their deviations alone.
std::string heights(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const int number = 2000 + 20 * i;
    text += step_aspect(number, bottom_face) + step_aspect(number + 2, top_face) + "#" + std::to_string(number + 4) +
            "=DIMENSIONAL_LOCATION('linear distance','',#" + std::to_string(number) + ",#" +
            std::to_string(number + 2) + ");\n" + size(number + 5, number + 4, "20.", "2.2") +
            deviations(number + 9, number + 4, "-0.1", "0." + std::to_string(1001 + i));
  }
  return text;
}

// Those that are drawn are on the paper, all others are told.
TEST_F(Pmi, DimensionsWithoutRoomAreTold) {
  constexpr int count = 60;
  const Outcome drawn = draw_box(heights(count), {"--pmi", "all", "--sheet", "180x140", "--scale", "1:1"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_FALSE(contains(drawn.err, "extend beyond the sheet")) << drawn.err;
  int shown = 0;
  for (const Json& one : ledger().items) {
    shown += one["view"].type != 'n' ? 1 : 0;
    EXPECT_EQ(one["view"].type == 'n', one["reason"].type != 'n') << one["id"].text;
  }
  EXPECT_GT(shown, 0);
  EXPECT_EQ(says("20.00 ") + says("20.00"), shown);
  EXPECT_TRUE(contains(drawn.err, std::to_string(count - shown) + " of the 60 requirements")) << drawn.err;
}

// Where one text finds no place, no larger one at the same faces does: many more take hardly more time.
TEST_F(Pmi, AThousandDimensionsWithoutRoomAreToldSoon) {
  const auto seconds = [this](int count) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome drawn = draw_box(heights(count), {"--pmi", "all", "--sheet", "A3"});
    EXPECT_EQ(drawn.code, has_importer_ ? 1 : 2) << drawn.err;
    EXPECT_TRUE(!has_importer_ || contains(drawn.err, " of the " + std::to_string(count) + " requirements"))
        << drawn.err;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const double hundred = seconds(100), thousand = seconds(1000);
  EXPECT_IMPORTER();
  EXPECT_LT(thousand, 6 * hundred) << hundred;
}

// A frame that is higher than the sheet has no place, and takes none from the views.
TEST_F(Pmi, AFrameHigherThanTheSheetIsTold) {
  std::string text = step_aspect(1900, top_face);
  for (int i = 0; i < 200; ++i)
    text += step_length(2000 + 2 * i, "0." + std::to_string(100 + i), "") + "#" + std::to_string(2001 + 2 * i) +
            "=FLATNESS_TOLERANCE('','',#" + std::to_string(2000 + 2 * i) + ",#1900);\n";
  const Outcome drawn = draw_box(text + height);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_FALSE(contains(drawn.err, "larger than the sheet")) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "200 of the 201 requirements of the models are not drawn:")) << drawn.err;
  EXPECT_EQ(row("#2001")["reason"].text, "there is no place for it in the view");
  EXPECT_EQ(row("#1004")["view"].text, "front");
}

// What is read in part would be drawn wrong: a size without its deviations, a hole that is one of several.
TEST_F(Pmi, WhatIsNotReadWholeIsToldAndNotDrawn) {
  const std::string lost = step_aspect(1000, bottom_face) + step_aspect(1002, top_face) +
                           "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                           size(1010, 1004, "20.", "2.2") +
                           "#1016=TOLERANCE_VALUE(#9998,#9999);\n#1017=PLUS_MINUS_TOLERANCE(#1016,#1004);\n";
  const std::string of_two =
      "#1100=SHAPE_ASPECT('','',#10,.T.);\n"
      "#1101=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1100,#50,#101);\n"
      "#1102=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#1100,#50,#9999);\n" +
      step_length(1103, "0.05", "") + "#1104=FLATNESS_TOLERANCE('','',#1103,#1100);\n";
  const std::string unit = step_aspect(1200, left_face) +
                           "#1202=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT("
                           "LENGTH_MEASURE(0.02),#9999)REPRESENTATION_ITEM(''));\n"
                           "#1203=FLATNESS_TOLERANCE('','',#1202,#1200);\n";
  const Outcome drawn = draw_box(lost + of_two + unit);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "3 of the 3 requirements of the models are not drawn:")) << drawn.err;
  EXPECT_EQ(row("#1004")["reason"].text, "not read: the values of its deviations");
  EXPECT_EQ(row("#1104")["reason"].text, "not read: 1 item without a face");
  EXPECT_EQ(row("#1203")["reason"].text, "not read: the unit of a value");
  EXPECT_EQ(says("20.00"), 0);
}

// Datums that refer to themselves, and composite tolerances that stand above each other.
TEST_F(Pmi, CirclesOfReferencesEndAndAreTold) {
  const std::string datums =
      step_aspect(1000, top_face) +
      "#1110=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,COMMON_DATUM_LIST((#1111,#1112)),$);\n"
      "#1111=DATUM_REFERENCE_ELEMENT('','',#10,.F.,#1110,$);\n#1112=DATUM_REFERENCE_ELEMENT('','',#10,.F.,#1111,$);\n"
      "#1113=DATUM_SYSTEM('','',#10,.F.,(#1110,#1113));\n" +
      step_length(1120, "0.2", "") + "#1121=PARALLELISM_TOLERANCE('','',#1120,#1000,(#1113));\n";
  const std::string above = step_length(1130, "0.4", "") +
                            "#1131=(GEOMETRIC_TOLERANCE('','',#1130,#1000)FLATNESS_TOLERANCE());\n"
                            "#1132=(GEOMETRIC_TOLERANCE('','',#1130,#1000)FLATNESS_TOLERANCE());\n"
                            "#1133=GEOMETRIC_TOLERANCE_RELATIONSHIP('composite tolerance','',#1131,#1132);\n"
                            "#1134=GEOMETRIC_TOLERANCE_RELATIONSHIP('composite tolerance','',#1132,#1131);\n";
  const Outcome drawn = draw_box(datums + above);
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_EQ(row("#1121")["reason"].text.find("not read: "), 0U) << row("#1121")["reason"].text;
  EXPECT_EQ(ledger().items.size(), 3U);
  for (const Json& one : ledger().items)
    EXPECT_TRUE(one["view"].type != 'n' || one["reason"].type != 'n') << one["id"].text;
}

// Of a seam, of an edge, of all of the part, and of its body, which is the same.
TEST_F(Pmi, WhatHoldsForNoFaceIsAtItsPlace) {
  const auto flat = [](int number, int item) {
    return step_aspect(number, item) + step_length(number + 2, "0.05", "") + "#" + std::to_string(number + 3) +
           "=STRAIGHTNESS_TOLERANCE('','',#" + std::to_string(number + 2) + ",#" + std::to_string(number) + ");\n";
  };
  constexpr int seam = 242, rim = 240, body = 52;
  const Outcome drawn =
      draw(step_shaft(6, 30,
                      flat(1000, seam) + flat(1010, rim) + flat(1020, body) + step_length(1030, "0.3", "") +
                          "#1031=SURFACE_PROFILE_TOLERANCE('','',#1030,#10);\n"),
           {"--pmi", "all"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(row("#1003")["view"].text, "front");
  EXPECT_NE(row("#1013")["view"].type, 'n');
  EXPECT_EQ(row("#1023")["sheet"].text, "1");
  EXPECT_EQ(row("#1031")["sheet"].text, "1");
  EXPECT_EQ(says("all over"), 2);
}

// Of a line of its surface, which a view along the axis shows as a point.
TEST_F(Pmi, StraightnessOfARoundFaceIsWhereItsLinesAreTrue) {
  const std::string all = step_aspect(1000, round_face) + step_length(1002, "0.05", "") +
                          "#1003=STRAIGHTNESS_TOLERANCE('','',#1002,#1000);\n";
  const Outcome drawn = draw(step_shaft(6, 30, all), {"--pmi", "all"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(row("#1003")["view"].text, "top");
  const std::string other = "#1004=CYLINDRICITY_TOLERANCE('','',#1002,#1000);\n";
  EXPECT_EQ(draw(step_shaft(6, 30, all + other), {"--pmi", "all", "--views", "top"}).code, 1);
  EXPECT_EQ(row("#1003")["view"].type, 'n');
  EXPECT_EQ(row("#1004")["view"].text, "top");
}

TEST_F(Pmi, OneKindAloneIsDrawnIfAsked) {
  const std::string flatness = step_length(1020, "0.05", "") + "#1021=FLATNESS_TOLERANCE('','',#1020,#1002);\n";
  const Outcome drawn = draw_box(height + flatness + datum(1100, bottom_face, "T"), {"--pmi", "tolerances"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(says("20.00 "), 0);
  EXPECT_EQ(says("0.05"), 1);
  EXPECT_EQ(says("T"), 1);
  EXPECT_EQ(row("#1004")["reason"].text, "--pmi tolerances leaves it out");
  EXPECT_EQ(draw_box(height + flatness, {"--pmi", "dimensions"}).code, 0);
  EXPECT_EQ(says("20.00 "), 1);
  EXPECT_EQ(says("0.05"), 0);
}

// The number of each characteristic stands beside it, and is that of the ledger.
TEST_F(Pmi, BalloonsHaveTheNumbersOfTheLedger) {
  const std::string flatness = step_length(1020, "0.05", "") + "#1021=FLATNESS_TOLERANCE('','',#1020,#1002);\n";
  const std::string all = height + flatness + datum(1100, bottom_face, "T");
  const Outcome drawn = draw_box(all, {"--pmi", "all", "--balloons", "characteristics"});
  EXPECT_IMPORTER();
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_EQ(row("#1004")["characteristic"].text, "1");
  EXPECT_EQ(row("#1021")["characteristic"].text, "2");
  EXPECT_EQ(row("#1102")["characteristic"].type, 'n');
  const int with = says("1") + says("2");
  EXPECT_EQ(draw_box(all).code, 0);
  EXPECT_EQ(with - says("1") - says("2"), 2);
  const Outcome none = draw_box("", {"--balloons", "characteristics"});
  EXPECT_TRUE(contains(none.err, "the models state nothing to be measured that is read")) << none.err;
}

// Those that are drawn with their field of the frame, the others with the reason.
TEST_F(Pmi, LintSaysWhereTheyAre) {
  const std::string hole = "#1030=SHAPE_ASPECT('','',#10,.T.);\n#1031=DIMENSIONAL_SIZE(#1030,'diameter');\n";
  folder_.file("part.step", step_box({40, 30, 20}, height + hole));
  const Outcome found =
      epura({"lint", "part.step", "--views", "front,top", "--pmi", "all", "--json", "l.json"}, folder_ / "");
  if (contains(found.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(found.code, 1);
  EXPECT_TRUE(contains(found.out, "requirements: 1 of 2 are drawn, 1 fault")) << found.out;
  const Json all = JsonReader(read_file(folder_ / "l.json")).read();
  EXPECT_EQ(Schema(read_file(root() / "src/run/app/lint.schema.json")).fault_of(all), "");
  const Json &drawn = all["requirements"].items.at(0), &lost = all["requirements"].items.at(1);
  EXPECT_EQ(drawn["id"].text, "#1004");
  EXPECT_EQ(drawn["view"].text, "front");
  EXPECT_EQ(drawn["sheet"].text, "1");
  EXPECT_EQ(drawn["sheet_zone"].text.size(), 2U) << drawn["sheet_zone"].text;
  EXPECT_EQ(drawn.keys().find("reason"), std::string::npos);
  EXPECT_EQ(lost.keys().find("view"), std::string::npos);
  EXPECT_EQ(lost["reason"].text, "not read: a value, a face that it belongs to");
}

TEST_F(Pmi, TheTitleBlockNamesTheStandard) {
  EXPECT_EQ(draw_box(height, {"--pmi", "all", "--standard", "ASME Y14.5-2018", "--frame", "full"}).code, 0);
  EXPECT_IMPORTER();
  EXPECT_EQ(says("ASME Y14.5-2018"), 1);
  EXPECT_EQ(says("Standard"), 1);
}

TEST_F(Pmi, AFaceThatNoViewShowsIsAReason) {
  folder_.file("part.step", step_box({40, 30, 20}, height));
  const Outcome drawn =
      epura({"draw", "part.step", "--views", "top,isometric", "--pmi", "all", "-o", "a.json"}, folder_ / "");
  if (contains(drawn.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(drawn.code, 1);
  EXPECT_EQ(row("#1004")["reason"].text, "no orthographic view of the sheet shows its faces: add the view 'front'");
}

}  // namespace
}  // namespace epura::test::pmi_test
