// SPDX-License-Identifier: Apache-2.0
// What STEP files require of their parts: files with a box, in which every value is known.
#include <chrono>
#include <cmath>
#include <map>

#include "importer/sink.hpp"
#include "step_box.hpp"
#include "support.hpp"

namespace epura::test::requirements_test {
namespace {

using importer::ModelRequirement;
using importer::ReadModel;
using importer::RequirementBounds;
using importer::RequirementKind;

ReadModel read(const std::string& statements, bool in_inches = false) {
  const Folder folder;
  return read_by_importer(folder.file("box.step", step_box({40, 30, 20}, statements, in_inches)));
}

/// "right", "top": by their outward normals.
std::string normals(const ReadModel& model, const ModelRequirement& requirement) {
  std::string text;
  for (const int face : requirement.faces) {
    const Vec3 axis = model.part->faces.at(static_cast<std::size_t>(face)).surface.axis;
    for (int k = 0; k < 3; ++k)
      if (std::abs(axis[k]) > 0.99) text += std::string(axis[k] > 0 ? "+" : "-") + "xyz"[k];
  }
  return text;
}

const ModelRequirement& named(const ReadModel& model, const std::string& id) {
  for (const ModelRequirement& one : model.requirements)
    if (one.id == id) return one;
  throw std::out_of_range("no requirement " + id);
}

// A width of 40 between left and right.
const std::string width = step_aspect(1000, left_face) + step_aspect(1002, right_face) +
                          "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n";

// A line of 30 along x beside the solid.
std::string straightness_of_line(const std::string& from) {
  return step_aspect(1000, 1301) + step_length(1002, "0.05", "") +
         "#1003=STRAIGHTNESS_TOLERANCE('','',#1002,#1000);\n#1300=GEOMETRIC_CURVE_SET('',(#1301));\n"
         "#1301=TRIMMED_CURVE('',#1302,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),.T.,.PARAMETER.);\n"
         "#1302=LINE('',#1303,#1304);\n#1303=CARTESIAN_POINT('',(" +
         from +
         "));\n#1304=VECTOR('',#1305,30.);\n#1305=DIRECTION('',(1.,0.,0.));\n"
         "#1310=SHAPE_REPRESENTATION('',(#1300),#30);\n#1311=SHAPE_REPRESENTATION_RELATIONSHIP('','',#50,#1310);\n";
}

// One on an edge lies on two faces, one that ends in the air on none.
TEST(Requirements, ALineOnAFaceIsOneOfItsElements) {
  const ReadModel on_top = read(straightness_of_line("5.,10.,20."));
  ASSERT_EQ(on_top.requirements.size(), 1U);
  EXPECT_EQ(normals(on_top, on_top.requirements.front()), "+z");
  EXPECT_EQ(on_top.requirements.front().missing, "");
  for (const char* from : {"5.,0.,20.", "15.,10.,20.", "5.,10.,25."}) {
    const ReadModel lost = read(straightness_of_line(from));
    EXPECT_TRUE(lost.requirements.front().faces.empty()) << from;
    EXPECT_EQ(lost.requirements.front().missing, "1 item without a face") << from;
  }
}

TEST(Requirements, ADimensionHasItsDeviationsAndDigits) {
  const ReadModel model =
      read(width + step_length(1010, "40.", "nominal value", "QUALIFIED_REPRESENTATION_ITEM((#1011))") +
           "#1011=VALUE_FORMAT_TYPE_QUALIFIER('NR2 2.3');\n" + step_values(1012, 1004, "#1010") +
           step_length(1014, "-0.25", "") + step_length(1015, "0.125", "") +
           "#1016=TOLERANCE_VALUE(#1014,#1015);\n#1017=PLUS_MINUS_TOLERANCE(#1016,#1004);\n");
  ASSERT_EQ(model.requirements.size(), 1U);
  const ModelRequirement& one = model.requirements.front();
  EXPECT_EQ(one.id, "#1004");
  EXPECT_EQ(one.kind, RequirementKind::dimension);
  EXPECT_EQ(one.type, "linear distance");
  EXPECT_EQ(one.value, 40);
  EXPECT_EQ(one.bounds, RequirementBounds::deviations);
  EXPECT_EQ(one.lower, -0.25);
  EXPECT_EQ(one.upper, 0.125);
  EXPECT_EQ(one.decimals, 3);
  EXPECT_EQ(one.unit, 1);
  EXPECT_EQ(normals(model, one), "-x+x");
  EXPECT_EQ(one.missing, "");
}

TEST(Requirements, ADimensionHasLimitsOrAFit) {
  const ReadModel model =
      read(width + step_length(1010, "39.5", "lower limit") + step_length(1011, "40.5", "upper limit") +
           step_values(1012, 1004, "#1010,#1011") + "#1020=DIMENSIONAL_SIZE(#1000,'diameter');\n" +
           step_length(1021, "8.", "nominal value") +
           "#1022=DESCRIPTIVE_REPRESENTATION_ITEM('dimensional note','auxiliary');\n" +
           step_values(1023, 1020, "#1021,#1022") +
           "#1025=LIMITS_AND_FITS('H','hole','7','');\n#1026=PLUS_MINUS_TOLERANCE(#1025,#1020);\n");
  const ModelRequirement &limits = named(model, "#1004"), &fit = named(model, "#1020");
  EXPECT_TRUE(std::isnan(limits.value));
  EXPECT_EQ(limits.bounds, RequirementBounds::limits);
  EXPECT_EQ(limits.lower, 39.5);
  EXPECT_EQ(limits.upper, 40.5);
  EXPECT_EQ(limits.missing, "");
  EXPECT_EQ(fit.type, "diameter");
  EXPECT_EQ(fit.value, 8);
  EXPECT_EQ(fit.fit, "H7");
  EXPECT_EQ(fit.modifiers, "auxiliary");
  EXPECT_EQ(fit.bounds, RequirementBounds::none);
}

TEST(Requirements, LengthsInInchesBecomeMillimetresAndAnglesDegrees) {
  const std::string angle =
      "#1020=ANGULAR_LOCATION('angle','',#1000,#1002,.EQUAL.);\n"
      "#1021=(MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(60.),#26)PLANE_ANGLE_MEASURE_WITH_"
      "UNIT()REPRESENTATION_ITEM('nominal value'));\n" +
      step_values(1022, 1020, "#1021");
  const ReadModel model = read(width + step_length(1010, "1.25", "nominal value") + step_values(1012, 1004, "#1010") +
                                   "#1014=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(-0.008),#20);\n"
                                   "#1015=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.03),#20);\n"
                                   "#1016=TOLERANCE_VALUE(#1014,#1015);\n#1017=PLUS_MINUS_TOLERANCE(#1016,#1004);\n" +
                                   angle,
                               true);
  const ModelRequirement &length = named(model, "#1004"), &turn = named(model, "#1020");
  EXPECT_EQ(length.value, 31.75);
  EXPECT_EQ(length.lower, -0.2032);
  EXPECT_EQ(length.upper, 0.762);
  EXPECT_EQ(length.unit, 25.4);
  EXPECT_FALSE(length.is_angle);
  EXPECT_EQ(turn.value, 60);
  EXPECT_TRUE(turn.is_angle);
}

TEST(Requirements, EveryKindOfGeometricToleranceIsRead) {
  const std::array kinds{"ANGULARITY", "CIRCULAR_RUNOUT", "COAXIALITY",      "CONCENTRICITY",    "CYLINDRICITY",
                         "FLATNESS",   "LINE_PROFILE",    "PARALLELISM",     "PERPENDICULARITY", "POSITION",
                         "ROUNDNESS",  "STRAIGHTNESS",    "SURFACE_PROFILE", "SYMMETRY",         "TOTAL_RUNOUT"};
  std::string statements = step_aspect(1000, top_face) + step_length(1002, "0.05", "");
  int number = 1010;
  for (const char* kind : kinds)
    statements += "#" + std::to_string(number++) + "=(GEOMETRIC_TOLERANCE('" + kind + "','',#1002,#1000)" + kind +
                  "_TOLERANCE());\n";
  statements += "#1030=FLATNESS_TOLERANCE('','',#1002,#1000);\n";
  const ReadModel model = read(statements);
  ASSERT_EQ(model.requirements.size(), kinds.size() + 1);
  for (const ModelRequirement& one : model.requirements) {
    std::string words = one.id == "#1030" ? "FLATNESS" : one.name;
    for (char& c : words) c = c == '_' ? ' ' : static_cast<char>(std::tolower(c));
    EXPECT_EQ(one.type, words);
    EXPECT_EQ(one.kind, RequirementKind::tolerance);
    EXPECT_EQ(one.value, 0.05);
    EXPECT_EQ(normals(model, one), "+z");
    EXPECT_EQ(one.missing, "");
  }
}

// Datums A at the bottom, B at the left and C in front, each by its feature.
const std::string datums =
    step_aspect(1100, bottom_face, "DATUM_FEATURE") + step_aspect(1102, left_face, "DATUM_FEATURE") +
    step_aspect(1104, front_face, "DATUM_FEATURE") +
    "#1110=DATUM('','',#10,.F.,'A');\n#1111=DATUM('','',#10,.F.,'B');\n#1112=DATUM('','',#10,.F.,'C');\n"
    "#1113=SHAPE_ASPECT_RELATIONSHIP('','',#1100,#1110);\n#1114=SHAPE_ASPECT_RELATIONSHIP('','',#1102,#1111);\n"
    "#1115=SHAPE_ASPECT_RELATIONSHIP('','',#1104,#1112);\n";

TEST(Requirements, ADatumSystemKeepsItsOrderAndModifiers) {
  const ReadModel model = read(
      datums + step_aspect(1000, top_face) + step_length(1002, "0.4", "") +
      "#1120=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,#1112,$);\n"
      "#1121=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,#1110,(SIMPLE_DATUM_REFERENCE_MODIFIER(.MAXIMUM_MATERIAL_"
      "REQUIREMENT.)));\n"
      "#1122=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,#1111,$);\n"
      "#1123=DATUM_SYSTEM('','',#10,.F.,(#1120,#1121,#1122));\n"
      "#1124=(GEOMETRIC_TOLERANCE('','',#1002,#1000)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#1123))"
      "GEOMETRIC_TOLERANCE_WITH_MODIFIERS((.MAXIMUM_MATERIAL_REQUIREMENT.,.FREE_STATE.))POSITION_TOLERANCE());\n"
      "#1125=TOLERANCE_ZONE('','',#10,.F.,(#1124),#1126);\n#1126=TOLERANCE_ZONE_FORM('cylindrical or circular');\n");
  const ModelRequirement& one = named(model, "#1124");
  EXPECT_EQ(one.datums, "C | A (maximum material requirement) | B");
  EXPECT_EQ(one.modifiers, "maximum material requirement, free state");
  EXPECT_EQ(one.zone, "cylindrical or circular");
  EXPECT_EQ(one.missing, "");
  const std::map<std::string, std::string> places{{"#1110", "-z"}, {"#1111", "-x"}, {"#1112", "-y"}};
  for (const auto& [id, normal] : places) EXPECT_EQ(normals(model, named(model, id)), normal);
  EXPECT_EQ(named(model, "#1111").datums, "B");
}

TEST(Requirements, CommonDatumsAreOneReferenceAndFramesOfACompositeStandBelow) {
  const ReadModel model = read(
      datums + step_aspect(1000, top_face) + step_length(1002, "0.4", "") + step_length(1003, "0.1", "") +
      "#1120=DATUM_REFERENCE_ELEMENT('','',#10,.F.,#1110,$);\n#1121=DATUM_REFERENCE_ELEMENT('','',#10,.F.,#1111,$);\n"
      "#1122=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,COMMON_DATUM_LIST((#1120,#1121)),$);\n"
      "#1123=DATUM_SYSTEM('','',#10,.F.,(#1122));\n"
      "#1124=PERPENDICULARITY_TOLERANCE('','',#1002,#1000,(#1123));\n"
      "#1125=(GEOMETRIC_TOLERANCE('','',#1003,#1000)PERPENDICULARITY_TOLERANCE());\n"
      "#1126=GEOMETRIC_TOLERANCE_RELATIONSHIP('composite tolerance','',#1124,#1125);\n");
  EXPECT_EQ(named(model, "#1124").datums, "A-B");
  EXPECT_EQ(named(model, "#1124").above, "");
  EXPECT_EQ(named(model, "#1125").above, "#1124");
  EXPECT_EQ(named(model, "#1125").value, 0.1);
}

// A distance of 40 between two edges of the box.
std::string between_edges(int one, int other) {
  return step_aspect(1000, one) + step_aspect(1002, other) +
         "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" + step_length(1010, "40.", "nominal value") +
         step_values(1012, 1004, "#1010");
}

TEST(Requirements, EdgesThatAreApartStandForTheOnlyFacesAtADistance) {
  const int bottom_left = step_box_edge(0, 2), top_left = step_box_edge(4, 6), top_right = step_box_edge(5, 7);
  const ReadModel model = read(between_edges(top_left, top_right));
  EXPECT_EQ(normals(model, model.requirements.at(0)), "-x+x");
  EXPECT_EQ(model.requirements.at(0).missing, "");
  const ReadModel with_face = read(between_edges(top_left, right_face));
  EXPECT_EQ(normals(with_face, with_face.requirements.at(0)), "-x+x");
  const ReadModel askew = read(between_edges(bottom_left, top_right));  // 40 apart, and 20
  EXPECT_EQ(normals(askew, askew.requirements.at(0)), "");
  EXPECT_EQ(askew.requirements.at(0).missing, "2 items without a face");
}

// Its form is that of the edge, in two halves.
TEST(Requirements, ACircleStandsForItsCylinderExceptForItsForm) {
  const Folder folder;
  const ReadModel model = read_by_importer(folder.file(
      "shaft.step", step_shaft(6, 30,
                               step_aspect(1000, 240) + "#1002=DIMENSIONAL_SIZE(#1000,'diameter');\n" +
                                   step_length(1003, "12.", "nominal value") + step_values(1004, 1002, "#1003") +
                                   step_length(1006, "0.1", "") + "#1007=ROUNDNESS_TOLERANCE('','',#1006,#1000);\n" +
                                   "#1008=POSITION_TOLERANCE('','',#1006,#1000,());\n")));
  ASSERT_EQ(named(model, "#1002").faces.size(), 1U);
  const int face = named(model, "#1002").faces[0];
  EXPECT_EQ(model.part->faces.at(static_cast<std::size_t>(face)).surface.kind, surfaces::SurfaceKind::cylinder);
  EXPECT_EQ(named(model, "#1002").missing, "");
  EXPECT_EQ(named(model, "#1008").faces, named(model, "#1002").faces);
  EXPECT_EQ(named(model, "#1007").faces.size(), 2U);
  EXPECT_EQ(named(model, "#1007").missing, "");
  const std::vector<std::array<double, 6>> halves{{6, 0, 0, -6, 0, 0}, {-6, 0, 0, 6, 0, 0}};
  ASSERT_EQ(named(model, "#1007").lines.size(), halves.size());
  for (std::size_t i = 0; i < halves.size(); ++i)
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(named(model, "#1007").lines[i][k], halves[i][k], 1e-9) << i << k;
}

// Two areas, one of which is a place beside the part.
TEST(Requirements, DatumTargetsHaveTheFaceOfTheirPlace) {
  for (const bool in_inches : {false, true}) {
    const ReadModel model =
        read(step_target(1100, "1", {10, 10, 20}) + step_target(1120, "2", {10, 10, 21}) +
                 "#1140=DATUM('','',#10,.F.,'A');\n#1141=SHAPE_ASPECT_RELATIONSHIP('','',#1100,#1140);\n"
                 "#1142=SHAPE_ASPECT_RELATIONSHIP('','',#1120,#1140);\n",
             in_inches);
    const ModelRequirement &on = named(model, "#1100"), &off = named(model, "#1120"), &datum = named(model, "#1140");
    EXPECT_EQ(on.datums, "A1");
    EXPECT_EQ(on.zone, "circle");
    EXPECT_EQ(on.modifiers, in_inches ? "target diameter 101.6 mm" : "target diameter 4 mm");
    EXPECT_EQ(normals(model, on), "+z");
    EXPECT_EQ(on.missing, "");
    const double unit = in_inches ? 25.4 : 1;
    const std::vector<std::array<double, 3>> area{{10, 10, 20}, {2, 0, 0}, {0, 2, 0}};
    ASSERT_EQ(on.area.size(), area.size());
    for (std::size_t i = 0; i < area.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(on.area[i][k], unit * area[i][k], 1e-9) << i << k;
    EXPECT_EQ(off.faces.size(), 0U);
    EXPECT_EQ(off.missing, "1 item without a face");
    EXPECT_EQ(normals(model, datum), "+z");
    EXPECT_EQ(datum.modifiers, "targets");
  }
}

TEST(Requirements, WhatCannotBeReadIsSaid) {
  const ReadModel model = read(
      "#1000=SHAPE_ASPECT('','',#10,.T.);\n#1001=DIMENSIONAL_SIZE(#1000,'diameter');\n" + step_aspect(1002, top_face) +
      "#1004=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.),#22);\n#1005=FLATNESS_TOLERANCE('','',#1004,#1002);\n" +
      step_length(1006, "0.1", "") +
      "#1007=(GEOMETRIC_TOLERANCE('','',#1006,#1002)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#1008))"
      "POSITION_TOLERANCE());\n#1008=DATUM_SYSTEM('','',#10,.F.,());\n" +
      step_length(1021, "8.", "nominal value", "QUALIFIED_REPRESENTATION_ITEM((#1022))") +
      "#1022=VALUE_FORMAT_TYPE_QUALIFIER('NR2 1.999999999');\n#1020=DIMENSIONAL_SIZE(#1002,'diameter');\n" +
      step_values(1023, 1020, "#1021") + "#1010=PROJECTED_ZONE_DEFINITION(#1005,(#1002),#1002,#1006);\n");
  EXPECT_EQ(named(model, "#1001").missing, "a value, a face that it belongs to");
  EXPECT_EQ(named(model, "#1005").missing, "the unit of a value");
  EXPECT_EQ(named(model, "#1020").decimals, -1);
  EXPECT_EQ(named(model, "#1007").missing, "a datum that it refers to");
  const std::vector<std::string>& notes = model.mesh.report.notes;
  EXPECT_EQ(importer::counted_requirements(model.requirements), "2 dimensions and 2 geometric tolerances");
  EXPECT_EQ(std::count(notes.begin(), notes.end(), "not read of what the file requires: 1 PROJECTED_ZONE_DEFINITION"),
            1);
}

// A picture of a requirement is not lost with it; others are.
TEST(Requirements, PicturesWithoutAMeaningAreCounted) {
  const std::string callouts =
      "#9001=DIMENSIONAL_SIZE(#10,'diameter');\n#9002=ANNOTATION_CURVE_OCCURRENCE('',(),#200);\n"
      "#9003=ANNOTATION_CURVE_OCCURRENCE('',(),#200);\n#9004=DRAUGHTING_CALLOUT('a',(#9002));\n"
      "#9005=DRAUGHTING_CALLOUT('b',(#9003));\n#9006=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#9001,#50,#9004);\n"
      "#9007=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#10,#50,#9005);\n";
  const auto pictures = [](const std::string& statements) {
    std::string found;
    for (const std::string& note : read(statements).mesh.report.notes)
      if (contains(note, "annotation")) found += note;
    return found;
  };
  EXPECT_EQ(pictures(callouts),
            "1 annotation of the file is a picture without a meaning that is read: not drawn "
            "(FILE:annotations=draw draws its lines)");
  EXPECT_EQ(pictures(callouts.substr(0, callouts.find("#9006="))),
            "2 annotations of the file are pictures without a meaning that is read: not drawn "
            "(FILE:annotations=draw draws its lines)");
  EXPECT_EQ(pictures("#9001=DIMENSIONAL_SIZE(#10,'diameter');\n"), "");
}

// The words of a property: of a callout, of an aspect, of the product. The picture of a dimension is no note.
std::string words(int number, int of, const std::string& name, const std::string& item, const std::string& text) {
  const auto n = [number](int more) { return "#" + std::to_string(number + more); };
  return n(0) + "=PROPERTY_DEFINITION('" + name + "','',#" + std::to_string(of) + ");\n" + n(1) +
         "=PROPERTY_DEFINITION_REPRESENTATION(" + n(0) + "," + n(2) + ");\n" + n(2) + "=REPRESENTATION('',(" + n(3) +
         "),#30);\n" + n(3) + "=DESCRIPTIVE_REPRESENTATION_ITEM('" + item + "','" + text + "');\n";
}

std::string picture(int number, const std::string& name, int shows) {
  const auto n = [number](int more) { return "#" + std::to_string(number + more); };
  return n(0) + "=ANNOTATION_CURVE_OCCURRENCE('',(),#200);\n" + n(1) + "=DRAUGHTING_CALLOUT('" + name + "',(" + n(0) +
         "));\n" + n(2) + "=DRAUGHTING_MODEL_ITEM_ASSOCIATION('','',#" + std::to_string(shows) + ",#50," + n(1) +
         ");\n";
}

TEST(Requirements, WordsOfPicturesAndPropertiesAreNotes) {
  const std::string unicode = "equivalent unicode string";
  const ReadModel model =
      read(step_aspect(1000, top_face) + picture(1010, "General note (1)", 10) +
           words(1020, 1011, "pmi validation property", unicode, "ALL EDGES\\X\\0AR0.5 MAX") +
           picture(1030, "Note (2)", 1000) + words(1040, 1031, "", unicode, "POLISH \\X2\\00B1\\X0\\") +
           "#1050=DIMENSIONAL_SIZE(#1000,'diameter');\n" + picture(1060, "Dimension", 1050) +
           words(1070, 1061, "", unicode, "8") + words(1080, 1000, "semantic text", "", "NO PAINT") +
           words(1090, 10, "user defined attribute", "Description", "a box"));
  std::string found;
  for (const ModelRequirement& one : model.requirements)
    if (one.kind == RequirementKind::note) found += one.id + " " + one.text + " " + normals(model, one) + "; ";
  EXPECT_EQ(found, "#1011 ALL EDGES R0.5 MAX ; #1031 POLISH ± +z; #1080 NO PAINT +z; ");
  EXPECT_EQ(named(model, "#1011").name, "General note (1)");
  for (const std::string& note : model.mesh.report.notes) EXPECT_FALSE(contains(note, "without a meaning")) << note;
}

// As polylines, as strips of a list of points, and as triangles, whose outline is drawn.
TEST(Requirements, PicturesWithoutAMeaningAreLinesOnDemand) {
  const std::string pictures =
      "#1000=POLYLINE('',(#1001,#1002,#1003));\n#1001=CARTESIAN_POINT('',(0.,0.,30.));\n"
      "#1002=CARTESIAN_POINT('',(8.,0.,30.));\n#1003=CARTESIAN_POINT('',(8.,5.,30.));\n"
      "#1004=GEOMETRIC_CURVE_SET('',(#1000));\n#1005=ANNOTATION_CURVE_OCCURRENCE('Text.1',(),#1004);\n"
      "#1006=DRAUGHTING_CALLOUT('Text.1',(#1005));\n"
      "#1010=COORDINATES_LIST('',3,((0.,0.,40.),(4.,0.,40.),(4.,3.,40.)));\n"
      "#1011=TESSELLATED_CURVE_SET('',#1010,((1,2),(2,3,9)));\n#1012=TESSELLATED_GEOMETRIC_SET('',(#1011,#1015));\n"
      "#1015=COMPLEX_TRIANGULATED_SURFACE_SET('',#1016,4,(),(),((1,2,3,4)),((1,3,1)));\n"
      "#1016=COORDINATES_LIST('',4,((0.,0.,50.),(1.,0.,50.),(0.,1.,50.),(1.,1.,50.)));\n"
      "#1013=TESSELLATED_ANNOTATION_OCCURRENCE('',(),#1012);\n#1014=DRAUGHTING_CALLOUT('Text.2',(#1013));\n";
  const Folder folder;
  importer::ReadOptions options;
  options.plugin_path = {EPURA_TEST_IMPORTERS};
  const ReadModel model = importer::read_model(folder.file("box.step", step_box({40, 30, 20}, pictures)),
                                               {{"annotations", "draw"}}, options);
  EXPECT_EQ(model.mesh.report.wires, 8);
  for (const std::string& note : model.mesh.report.notes) EXPECT_FALSE(contains(note, "annotation")) << note;
  EXPECT_EQ(read(pictures).mesh.report.wires, 0);
}

// Letters that the file has as such.
TEST(Requirements, LettersOfAnnotationsAreNotes) {
  const ReadModel model = read(
      "#1000=ANNOTATION_TEXT_OCCURRENCE('note',(),#1001);\n#1001=COMPOSITE_TEXT('',(#1002,#1003,#1001));\n"
      "#1002=TEXT_LITERAL('','HEAT TREAT',$,'left',.RIGHT.,$);\n"
      "#1003=(GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')TEXT_LITERAL('58 HRC',$,'left',.RIGHT.,$));\n"
      "#1004=ANNOTATION_TEXT_OCCURRENCE('',(),#9999);\n");
  ASSERT_EQ(model.requirements.size(), 1U);
  EXPECT_EQ(model.requirements.front().id, "#1000");
  EXPECT_EQ(model.requirements.front().text, "HEAT TREAT 58 HRC");
}

TEST(Requirements, ADatumReferenceToItselfIsSaid) {
  const ReadModel model = read(
      "#1120=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,COMMON_DATUM_LIST((#1121)),$);\n"
      "#1121=DATUM_REFERENCE_ELEMENT('','',#10,.F.,COMMON_DATUM_LIST((#1121)),$);\n"
      "#1123=DATUM_SYSTEM('','',#10,.F.,(#1120));\n" +
      step_aspect(1000, top_face) + step_length(1002, "0.4", "") +
      "#1124=PERPENDICULARITY_TOLERANCE('','',#1002,#1000,(#1123));\n");
  EXPECT_EQ(named(model, "#1124").missing, "a datum that it refers to");
}

TEST(Requirements, AspectsThatContainEachOtherAreFollowedOnce) {
  const ReadModel model = read(step_aspect(1000, top_face) + step_aspect(1002, bottom_face) +
                               "#1004=SHAPE_ASPECT_RELATIONSHIP('','',#1000,#1002);\n"
                               "#1005=SHAPE_ASPECT_RELATIONSHIP('','',#1002,#1000);\n" +
                               step_length(1006, "0.4", "") + "#1007=FLATNESS_TOLERANCE('','',#1006,#1000);\n");
  EXPECT_EQ(named(model, "#1007").faces.size(), 2U);
}

TEST(Requirements, AHundredThousandAreReadInTime) {
  constexpr int many = 100'000;
  constexpr double seconds = 60;  // 14 without optimisation, on a busy machine
  std::string statements = step_aspect(1000, top_face) + step_length(1002, "0.4", "");
  for (int i = 0; i < many; ++i)
    statements += "#" + std::to_string(2000 + i) + "=FLATNESS_TOLERANCE('','',#1002,#1000);\n";
  const auto begin = std::chrono::steady_clock::now();
  const ReadModel model = read(statements);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), seconds);
  EXPECT_EQ(model.requirements.size(), static_cast<std::size_t>(many));
  EXPECT_EQ(normals(model, model.requirements.back()), "+z");
}

// The border of the importer.

epura_requirement flatness(const char* id) {
  epura_requirement told{};
  told.size = sizeof told;
  told.kind = EPURA_TOLERANCE;
  told.id = id;
  told.type = "flatness";
  told.value = 0.1;
  told.decimals = -1;
  return told;
}

std::string fault_of(const epura_requirement& told) {
  importer::DocumentSink sink([](double) {});
  const epura_sink& calls = sink.calls();
  const epura_face plane{sizeof(epura_face), EPURA_PLANE, {0, 0, 0}, {0, 0, 1}, 0, 0, 0};
  EXPECT_EQ(calls.shape(calls.host, "plate"), 0);
  EXPECT_EQ(calls.face(calls.host, &plane), 0);
  const epura_requirement first = flatness("first");
  EXPECT_EQ(calls.requirement(calls.host, &first), 0);
  const int answer = calls.requirement(calls.host, &told);
  EXPECT_EQ(answer != 0, !sink.fault().empty());
  return sink.fault();
}

TEST(Requirements, TheBorderTakesSoundOnesAlone) {
  const std::array<std::uint32_t, 2> known{0, 0}, unknown{0, 1};
  epura_requirement told = flatness("second");
  told.face_count = 1;
  told.faces = known.data();
  EXPECT_EQ(fault_of(told), "");
  told.faces = unknown.data();
  EXPECT_EQ(fault_of(told), "hands over the requirement second with a face that it does not hand over");
  EXPECT_EQ(fault_of(flatness("first")), "hands over a requirement whose id is empty or that of another one");
  EXPECT_EQ(fault_of(flatness("")), "hands over a requirement whose id is empty or that of another one");
  epura_requirement strange = flatness("second");
  strange.kind = 7;
  EXPECT_EQ(fault_of(strange), "hands over the requirement second of unknown kind or with unknown bounds");
  epura_requirement exact = flatness("second");
  exact.decimals = 1'000'000'000;
  EXPECT_EQ(fault_of(exact), "hands over the requirement second with decimals that no number has");
  epura_requirement nowhere = flatness("second");
  const std::array<double, 9> place{0, 0, 0, 1, 0, 0, 0, NAN, 0};
  nowhere.area = place.data();
  EXPECT_EQ(fault_of(nowhere), "hands over the requirement second with places that are not finite");
  epura_requirement no_lines = flatness("second");
  no_lines.line_count = 1;
  EXPECT_EQ(fault_of(no_lines), "hands over no lines of the requirement second");
}

}  // namespace
}  // namespace epura::test::requirements_test
