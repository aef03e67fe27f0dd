// SPDX-License-Identifier: Apache-2.0
// epura requirements --qif: plans as the schema of QIF wants them, as far as qif.xsd beside this file repeats it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <pugixml.hpp>
#include <regex>

#include "app/qif_characteristics.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "step_box.hpp"

namespace epura::test::qif_test {
namespace {

std::string n(int number) { return std::to_string(number); }

std::string datum(int number, int face, const std::string& letter) {
  return step_aspect(number, face, "DATUM_FEATURE") + "#" + n(number + 2) + "=DATUM('','',#10,.F.,'" + letter +
         "');\n#" + n(number + 3) + "=SHAPE_ASPECT_RELATIONSHIP('','',#" + n(number) + ",#" + n(number + 2) + ");\n";
}

// A dimension of this type of the top, or from the bottom to it, with a value and further items of it.
std::string dimension(int number, const std::string& type, const std::string& items) {
  const std::string aspects = step_aspect(number, top_face) + step_aspect(number + 2, bottom_face);
  const std::string own = type.find("distance") == std::string::npos
                              ? "DIMENSIONAL_SIZE(#" + n(number) + ",'" + type + "')"
                              : "DIMENSIONAL_LOCATION('" + type + "','',#" + n(number + 2) + ",#" + n(number) + ")";
  return aspects + "#" + n(number + 4) + "=" + own + ";\n" + step_values(number + 5, number + 4, items);
}

std::string tolerance(int number, const std::string& keyword, const std::string& datums) {
  return step_length(number + 1, "0.05", "") + "#" + n(number) + "=" + keyword + "_TOLERANCE('','',#" + n(number + 1) +
         ",#2000" + datums + ");\n";
}

// Every kind that files have.
std::string everything() {
  std::string text = step_aspect(2000, top_face) + datum(2010, bottom_face, "A") + datum(2020, left_face, "B") +
                     "#2030=DATUM_REFERENCE_ELEMENT('','',#10,.F.,#2012,$);\n"
                     "#2031=DATUM_REFERENCE_ELEMENT('','',#10,.F.,#2022,$);\n"
                     "#2032=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,COMMON_DATUM_LIST((#2030,#2031)),$);\n"
                     "#2033=DATUM_REFERENCE_COMPARTMENT('','',#10,.F.,#2012,(SIMPLE_DATUM_REFERENCE_MODIFIER("
                     ".MAXIMUM_MATERIAL_REQUIREMENT.)));\n"
                     "#2034=DATUM_SYSTEM('','',#10,.F.,(#2032,#2033));\n" +
                     step_target(2050, "1", {5, 5, 0}) + "#2060=SHAPE_ASPECT_RELATIONSHIP('','',#2012,#2050);\n";
  text +=
      step_length(2100, "20.", "nominal value", "QUALIFIED_REPRESENTATION_ITEM((#2101))") +
      "#2101=VALUE_FORMAT_TYPE_QUALIFIER('NR2 2.2');\n#2102=DESCRIPTIVE_REPRESENTATION_ITEM('','theoretical');\n"
      "#2103=DESCRIPTIVE_REPRESENTATION_ITEM('','auxiliary');\n#2104=DESCRIPTIVE_REPRESENTATION_ITEM('','square');\n"
      "#2105=DESCRIPTIVE_REPRESENTATION_ITEM('','controlled radius');\n" +
      step_length(2106, "20.1", "upper limit") + step_length(2107, "19.9", "lower limit");
  int number = 3000;
  const auto add = [&](const std::string& type, const std::string& items) {
    number += 10;
    text += dimension(number, type, items);
  };
  for (const char* type : {"diameter", "radius", "spherical diameter", "spherical radius", "thickness", "curve length",
                           "linear distance", "toroidal minor diameter", "width"})
    add(type, "#2100");
  add("diameter", "#2106,#2107");
  add("linear distance", "#2100,#2102");
  add("linear distance", "#2100,#2103");
  add("width", "#2100,#2104");
  add("radius", "#2100,#2105");
  add("diameter", "#2100");
  text += "#2110=LIMITS_AND_FITS('H','hole','7','');\n#2111=PLUS_MINUS_TOLERANCE(#2110,#" + n(number + 4) + ");\n";
  add("linear distance", "#2100");
  text += step_length(2120, "-0.1", "") + step_length(2121, "0.3", "") +
          "#2122=TOLERANCE_VALUE(#2120,#2121);\n#2123=PLUS_MINUS_TOLERANCE(#2122,#" + n(number + 4) + ");\n";
  text += step_aspect(2130, top_face) + step_aspect(2132, left_face) +
          "#2134=ANGULAR_LOCATION('','',#2130,#2132,.SMALL.);\n"
          "#2135=(MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(90.),#26)"
          "PLANE_ANGLE_MEASURE_WITH_UNIT()REPRESENTATION_ITEM('nominal value'));\n" +
          step_values(2136, 2134, "#2135");
  number = 4000;
  for (const char* keyword :
       {"FLATNESS", "STRAIGHTNESS", "ROUNDNESS", "CYLINDRICITY", "LINE_PROFILE", "SURFACE_PROFILE"})
    text += tolerance(number += 10, keyword, "");
  for (const char* keyword : {"PARALLELISM", "PERPENDICULARITY", "ANGULARITY", "POSITION", "CONCENTRICITY",
                              "COAXIALITY", "SYMMETRY", "CIRCULAR_RUNOUT", "TOTAL_RUNOUT"})
    text += tolerance(number += 10, keyword, ",(#2034)");
  return text + step_length(2201, "0.05", "") +
         "#2200=(GEOMETRIC_TOLERANCE('','',#2201,#2000)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#2034))"
         "GEOMETRIC_TOLERANCE_WITH_MODIFIERS((.MAXIMUM_MATERIAL_REQUIREMENT.,.FREE_STATE.))POSITION_TOLERANCE());\n"
         "#2202=TOLERANCE_ZONE_FORM('cylindrical or circular');\n#2203=TOLERANCE_ZONE('','',#10,.F.,(#2200),#2202);\n";
}

class Qif : public testing::Test {
 protected:
  // Writes the plan of a box with this and reads it.
  Outcome write(const std::string& statements, bool in_inches = false) {
    folder_.file("box.step", step_box({40, 30, 20}, statements, in_inches));
    const Outcome done = epura({"requirements", "box.step", "--qif", "a.qif"}, folder_ / "");
    has_importer_ = !contains(done.err, "install the package");
    plan_.load_file((folder_ / "a.qif").c_str());
    return done;
  }
  // What xmllint says of it; empty: it is valid.
  [[nodiscard]] std::string fault_of(const std::string& file) const {
    const std::string schema = (root() / "tests/unit/app/qif.xsd").string(), said = folder_ / "said";
    const std::string command =
        "xmllint --noout --schema '" + schema + "' '" + (folder_ / file).string() + "' 2>'" + said + "'";
    return std::system(command.c_str()) == 0 ? "" : read_file(said);
  }
  // The text of the only element that an XPath finds, without the namespace.
  [[nodiscard]] std::string text(const std::string& xpath) const {
    const pugi::xpath_node_set found = plan_.select_nodes(xpath.c_str());
    return found.size() == 1 ? found.first().node().text().get() : "found " + std::to_string(found.size());
  }
  [[nodiscard]] std::size_t count(const std::string& xpath) const { return plan_.select_nodes(xpath.c_str()).size(); }

  Folder folder_;
  pugi::xml_document plan_{};
  bool has_importer_ = false;
};

#define EXPECT_IMPORTER() \
  if (!has_importer_) GTEST_SKIP() << "there is no importer of STEP"

TEST_F(Qif, APlanOfEveryKindIsValid) {
  write(everything());
  EXPECT_IMPORTER();
  EXPECT_EQ(fault_of("a.qif"), "");
  // None is lost, and no measured one lacks its item.
  EXPECT_EQ(count("//CharacteristicDefinitions/*"), 17U + 16U);
  EXPECT_EQ(count("//CharacteristicNominals/*"), 17U + 16U);
  EXPECT_EQ(count("//CharacteristicItems/*"), 17U + 16U - 1U);
  EXPECT_EQ(count("//UserDefinedAttributeCharacteristicDefinition"), 1U);  // the profile of a line
  EXPECT_EQ(count("//DatumTarget"), 1U);
  EXPECT_EQ(text("//DatumTargetLabel"), "A1");
  EXPECT_EQ(count("//CompoundDatum/Datum"), 2U);
}

// The schema does not take everything: it sees a wrong order, a lost reference, and an id that is there twice.
TEST_F(Qif, TheSchemaSeesFaults) {
  write(everything());
  EXPECT_IMPORTER();
  const std::string plan = read_file(folder_ / "a.qif");
  const auto changed = [&](const std::string& from, const std::string& to) {
    const std::string other = std::regex_replace(plan, std::regex(from), to, std::regex_constants::format_first_only);
    EXPECT_NE(other, plan) << from;
    folder_.file("b.qif", other);
    return fault_of("b.qif");
  };
  EXPECT_NE(changed("(<MaterialCondition>.*</MaterialCondition>)(\\s*)(<ZoneShape>\\s*.*\\s*</ZoneShape>)", "$3$2$1"),
            "");
  EXPECT_NE(changed("<DatumDefinitionId>\\d+<", "<DatumDefinitionId>999999<"), "");
  EXPECT_NE(changed("FlatnessCharacteristicDefinition id=\"\\d+\"", "FlatnessCharacteristicDefinition id=\"1\""), "");
  EXPECT_NE(changed("<CharacteristicNominals n", "<CharacteristicNominal n"), "");
}

TEST_F(Qif, ValuesAreThoseOfTheFile) {
  write(everything());
  EXPECT_IMPORTER();
  const std::string of_distance = "//DistanceBetweenCharacteristicDefinition[Tolerance]";
  EXPECT_EQ(text(of_distance + "/Tolerance/MaxValue"), "0.3");
  EXPECT_EQ(text(of_distance + "/Tolerance/MinValue"), "-0.1");
  EXPECT_EQ(text(of_distance + "/Tolerance/DefinedAsLimit"), "false");
  const std::string id = plan_.select_node((of_distance + "/@id").c_str()).attribute().value();
  const std::string nominal = "//DistanceBetweenCharacteristicNominal[CharacteristicDefinitionId='" + id + "']";
  EXPECT_EQ(text(nominal + "/TargetValue"), "20");
  EXPECT_STREQ(plan_.select_node((nominal + "/TargetValue/@decimalPlaces").c_str()).attribute().value(), "2");
  const std::string of_limits = "//DiameterCharacteristicDefinition[Tolerance]/Tolerance";
  EXPECT_EQ(text(of_limits + "/MaxValue") + " " + text(of_limits + "/MinValue"), "20.1 19.9");
  EXPECT_EQ(text(of_limits + "/DefinedAsLimit"), "true");
  EXPECT_EQ(text("//LimitsAndFitsSpecification/FormVariance") + text("//LimitsAndFitsSpecification/Grade"), "H7");
  const std::string position = "//PositionCharacteristicDefinition[FreeState]";
  EXPECT_EQ(text(position + "/MaterialCondition"), "MAXIMUM");
  EXPECT_EQ(count(position + "/ZoneShape/DiametricalZone"), 1U);
  const std::string frame = text(position + "/DatumReferenceFrameId");
  const std::string datums = "//DatumReferenceFrame[@id='" + frame + "']/Datums/Datum";
  EXPECT_EQ(text(datums + "[2]/SimpleDatum/MaterialModifier"), "MAXIMUM");
  EXPECT_EQ(text(datums + "[2]/Precedence/PrecedenceEnum"), "SECONDARY");
  EXPECT_EQ(text("//AngleBetweenCharacteristicNominal/TargetValue"), "90");
  // The top is a plane at 20 that looks up.
  EXPECT_EQ(count("//PlaneFeatureNominal[Normal='0 0 1' and substring-after(substring-after(Location,' '),' ')='20']"),
            1U);
}

// Plans of one file are the same; those of its next revision keep the identities of what is still there.
TEST_F(Qif, IdentitiesStay) {
  write(everything());
  EXPECT_IMPORTER();
  const std::string plan = read_file(folder_ / "a.qif");
  const std::string flatness = text("//FlatnessCharacteristicItem/CharacteristicDesignator/UUID");
  const std::string document = text("/QIFDocument/QPId");
  write(everything());
  EXPECT_EQ(read_file(folder_ / "a.qif"), plan);
  write(everything() + tolerance(5000, "FLATNESS", ""));
  EXPECT_EQ(text("//FlatnessCharacteristicItem[Name='#4010']/CharacteristicDesignator/UUID"), flatness);
  EXPECT_NE(text("/QIFDocument/QPId"), document);
  EXPECT_EQ(fault_of("a.qif"), "");
}

// One that the file gives stays, even if the file is renamed or written anew.
TEST_F(Qif, TheIdentityOfTheFileIsThatOfThePlan) {
  const std::string identity = "F81D4FAE-7DEC-11D0-A765-00A0C91E6BF6";
  write(tolerance(4000, "FLATNESS", "") + "#4090=V5_UUID_ATTRIBUTE('" + identity + "',(#4000));\n");
  EXPECT_IMPORTER();
  EXPECT_EQ(text("//FlatnessCharacteristicItem/CharacteristicDesignator/UUID"), "f81d4fae-7dec-11d0-a765-00a0c91e6bf6");
  EXPECT_EQ(fault_of("a.qif"), "");
}

TEST_F(Qif, InchesStayInches) {
  write(dimension(3000, "linear distance", "#2100") + step_length(2100, "20.", "nominal value"), true);
  EXPECT_IMPORTER();
  EXPECT_EQ(fault_of("a.qif"), "");
  EXPECT_EQ(text("//LinearUnit/UnitName"), "inch");
  EXPECT_EQ(text("//DistanceBetweenCharacteristicNominal/TargetValue"), "20");
  EXPECT_EQ(text("//StandardsOrganizationEnum"), "ASME");
}

// Of tolerances and of the datums that they refer to: one function for both.
TEST(QifMaterial, IsWhatTheModifiersSay) {
  EXPECT_EQ(qif::material_of("free state, maximum material requirement"), "MAXIMUM");
  EXPECT_EQ(qif::material_of("least material condition"), "LEAST");
  EXPECT_EQ(qif::material_of("maximum material requirement, reciprocity requirement"), "MAXIMUM_RPR");
  EXPECT_EQ(qif::material_of("least material requirement, reciprocity requirement"), "LEAST_RPR");
  EXPECT_EQ(qif::material_of("regardless of feature size"), "REGARDLESS");
  EXPECT_EQ(qif::material_of("reciprocity requirement"), "NONE");
  EXPECT_EQ(qif::material_of("maximum 0.2 mm"), "NONE");
}

TEST_F(Qif, AFileWithoutRequirementsIsAPlanOfNothing) {
  const Outcome done = epura({"requirements", sample("bracket.obj"), "--qif", "a.qif"}, folder_ / "");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(fault_of("a.qif"), "");
}

}  // namespace
}  // namespace epura::test::qif_test
