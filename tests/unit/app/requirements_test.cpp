// SPDX-License-Identifier: Apache-2.0
// epura requirements, and what epura info and epura draw say of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "step_box.hpp"

namespace epura::test::requirements_command_test {
namespace {

// A height of 20 -0.1/+0.3 and a flatness of 0.05 of the top, and a hole that is not there.
std::string some_requirements() {
  return step_aspect(1000, bottom_face) + step_aspect(1002, top_face) +
         "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
         step_length(1010, "20.", "nominal value", "QUALIFIED_REPRESENTATION_ITEM((#1011))") +
         "#1011=VALUE_FORMAT_TYPE_QUALIFIER('NR2 2.2');\n" + step_values(1012, 1004, "#1010") +
         step_length(1014, "-0.1", "") + step_length(1015, "0.3", "") +
         "#1016=TOLERANCE_VALUE(#1014,#1015);\n#1017=PLUS_MINUS_TOLERANCE(#1016,#1004);\n" +
         step_length(1020, "0.05", "") + "#1021=FLATNESS_TOLERANCE('flat, \"top\"','',#1020,#1002);\n";
}

const std::string hole = "#1030=SHAPE_ASPECT('','',#10,.T.);\n#1031=DIMENSIONAL_SIZE(#1030,'diameter');\n";

class RequirementsCommand : public testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& words, const std::string& statements, bool in_inches = false) {
    folder_.file("box.step", step_box({40, 30, 20}, statements, in_inches));
    return epura(words, folder_ / "");
  }
  // With the last one.
  Outcome compare_with(const std::string& statements, std::vector<std::string> options) {
    folder_.file("next.step", step_box({40, 30, 20}, statements, false));
    options.insert(options.begin(), {"compare", "box.step", "next.step"});
    return epura(options, folder_ / "");
  }
  [[nodiscard]] std::string text(const std::string& file) const { return read_file(folder_ / file); }

  Folder folder_;
};

TEST_F(RequirementsCommand, ListsThemInWords) {
  const Outcome listed = run({"requirements", "box.step"}, some_requirements());
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_TRUE(
      std::regex_search(listed.out, std::regex("  #1004 +linear distance 20\\.00 -0\\.1/\\+0\\.3 mm; faces \\d \\d\n")))
      << listed.out;
  EXPECT_TRUE(std::regex_search(listed.out, std::regex("  #1021 +flatness 0\\.05 mm; face \\d\n"))) << listed.out;
  EXPECT_TRUE(contains(listed.out, "  1 dimension and 1 geometric tolerance\n")) << listed.out;
}

TEST_F(RequirementsCommand, KeepsTheUnitOfTheFile) {
  const Outcome listed = run({"requirements", "box.step"}, some_requirements(), true);
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_TRUE(contains(listed.out, "linear distance 20.00 -0.1/+0.3 in; faces")) << listed.out;
}

TEST_F(RequirementsCommand, SaysWhatIsMissingByItsExitCode) {
  const Outcome listed = run({"requirements", "box.step"}, some_requirements() + hole);
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(listed.code, 1);
  EXPECT_TRUE(contains(listed.out, "diameter; no face; not read: a value, a face that it belongs to\n")) << listed.out;
}

TEST_F(RequirementsCommand, WritesJsonAndCsv) {
  const Outcome listed = run({"requirements", "box.step", "--json", "a.json", "--csv", "a.csv"}, some_requirements());
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(listed.code, 0) << listed.err;
  const Json json = JsonReader(text("a.json")).read();
  EXPECT_EQ(json["epura_requirements"].text, "1");
  const Json all = json["models"].items.at(0)["requirements"];
  ASSERT_EQ(all.items.size(), 2U);
  const Json &height = all.items[0], &flatness = all.items[1];
  EXPECT_EQ(height["id"].text, "#1004");
  EXPECT_EQ(height["kind"].text, "dimension");
  EXPECT_EQ(height["value"].number(), 20);
  EXPECT_EQ(height["lower"].number(), -0.1);
  EXPECT_EQ(height["upper"].number(), 0.3);
  EXPECT_EQ(height["bounds"].text, "deviations");
  EXPECT_EQ(height["decimals"].text, "2");
  EXPECT_EQ(height["faces"].items.size(), 2U);
  EXPECT_EQ(flatness["kind"].text, "tolerance");
  EXPECT_EQ(flatness["value"].number(), 0.05);
  EXPECT_EQ(flatness["name"].text, "flat, \"top\"");
  EXPECT_EQ(flatness["faces"].items.size(), 1U);
  const std::string csv = text("a.csv");
  EXPECT_TRUE(csv.starts_with("model,id,kind,type,name,value,lower,upper,bounds,is_angle,unit,decimals,")) << csv;
  EXPECT_TRUE(contains(csv, "box.step,#1004,dimension,linear distance,linear distance,20,-0.1,0.3,deviations,no,1,2,,"))
      << csv;
  EXPECT_TRUE(contains(csv, "box.step,#1021,tolerance,flatness,\"flat, \"\"top\"\"\",0.05,,,none,no,1,,,")) << csv;
}

// Rows of form 3 of AS9102: datums and auxiliary dimensions are not measured.
TEST_F(RequirementsCommand, WritesTheFormOfFirstArticles) {
  const std::string auxiliary = "#1030=DIMENSIONAL_LOCATION('linear distance','',#1002,#1000);\n" +
                                step_length(1031, "20.", "nominal value") +
                                "#1032=DESCRIPTIVE_REPRESENTATION_ITEM('dimensional note','auxiliary');\n" +
                                step_values(1033, 1030, "#1031,#1032");
  const std::string datum = step_aspect(1040, bottom_face, "DATUM_FEATURE") + "#1042=DATUM('','',#10,.F.,'A');\n" +
                            "#1043=SHAPE_ASPECT_RELATIONSHIP('','',#1040,#1042);\n";
  const std::string length = step_aspect(1050, left_face) + step_aspect(1052, right_face) +
                             "#1054=DIMENSIONAL_LOCATION('linear distance','',#1050,#1052);\n" +
                             step_length(1055, "40.", "nominal value") + step_values(1056, 1054, "#1055");
  const std::string all = some_requirements() + auxiliary + datum + length;
  const Outcome listed = run({"requirements", "box.step", "--as9102", "form.csv", "--json", "a.json"}, all);
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_EQ(text("form.csv"),
            "5. Char. No.,6. Reference Location,7. Characteristic Designator,8. Requirement,9. Results,"
            "10. Designed / Qualified Tooling,11. Nonconformance Number,12. Additional Data / Comments\r\n"
            "1,box.step #1004,,linear distance 20.00 -0.1/+0.3 mm,,,,\r\n"
            "2,box.step #1021,,flatness 0.05 mm,,,,\r\n"
            "3,box.step #1054,,linear distance 40 mm,,,,\r\n");
  const Json rows = JsonReader(text("a.json")).read()["models"].items.at(0)["requirements"];
  std::string numbers;
  for (const Json& row : rows.items) numbers += row["characteristic"].type == 'n' ? "-" : row["characteristic"].text;
  EXPECT_EQ(numbers, "12--3");
}

TEST_F(RequirementsCommand, InfoCountsThemAndADrawingSaysThatTheyAreNotDrawn) {
  const Outcome info = run({"info", "box.step"}, some_requirements());
  if (contains(info.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_TRUE(contains(info.out, "  dimensions 1: 1 linear distance\n")) << info.out;
  EXPECT_TRUE(contains(info.out, "  tolerances 1: 1 flatness\n")) << info.out;
  const Outcome drawn = run({"draw", "box.step", "-o", "a.svg"}, some_requirements());
  EXPECT_EQ(drawn.code, 0);
  EXPECT_TRUE(contains(drawn.err,
                       "1 dimension and 1 geometric tolerance of the file are not drawn: epura requirements "
                       "lists what the file requires"))
      << drawn.err;
}

TEST_F(RequirementsCommand, SaysWhereThereAreNone) {
  const Outcome listed = run({"requirements", sample("bracket.obj")}, "");
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_TRUE(contains(listed.out, "the file states no requirements that are read\n")) << listed.out;
}

// The next revision: another deviation, no flatness, and the order and the ids of all that stays changed.
TEST_F(RequirementsCommand, AreComparedBetweenRevisions) {
  run({"requirements", "box.step"}, some_requirements());
  const std::string flatness = "#1021=FLATNESS_TOLERANCE";
  std::string next = some_requirements();
  next.erase(next.find(flatness));
  next.replace(next.find("0.3"), 3, "0.2");
  next = std::regex_replace(next, std::regex("#10([0-9]{2})\\b"), "#17$1");
  const Outcome listed = compare_with(next, {"--json", "a.json", "--markdown", "a.md"});
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(listed.code, 1) << listed.err;
  EXPECT_EQ(listed.out,
            "changed    requirement: linear distance 20.00 -0.1/+0.3 mm -> linear distance 20.00 -0.1/+0.2 mm\n"
            "removed    requirement: flatness 0.05 mm\n"
            "2 requirements differ\n"
            "no differences above 0.001 mm\n");
  const Json json = JsonReader(text("a.json")).read();
  EXPECT_TRUE(contains(text("a.json"), "\"same\": false")) << text("a.json");
  ASSERT_EQ(json["requirements"].items.size(), 2U);
  EXPECT_EQ(json["requirements"].items[1]["change"].text, "removed");
  EXPECT_EQ(json["requirements"].items[1]["before"].text, "flatness 0.05 mm");
  EXPECT_TRUE(contains(text("a.md"), "- `removed    requirement: flatness 0.05 mm`\n")) << text("a.md");
  EXPECT_TRUE(contains(text("a.md"), "2 requirements differ; no differences above 0.001 mm\n")) << text("a.md");
  const Outcome same = compare_with(some_requirements(), {});
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_EQ(same.out, "no differences above 0.001 mm\n");
}

// Whatever else has changed: more lines than a comment has room for.
TEST_F(RequirementsCommand, AreFirstInAComment) {
  run({"requirements", "box.step"}, some_requirements());
  std::string next = some_requirements();
  next.replace(next.find("0.05"), 4, "0.07");
  folder_.file("next.step", step_box({45, 35, 20}, next));
  const Outcome listed = epura({"compare", "box.step", "next.step", "--markdown", "a.md"}, folder_ / "");
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(listed.code, 1) << listed.err;
  const std::string comment = text("a.md");
  EXPECT_TRUE(contains(comment, "\n\n- `changed    requirement: flatness 0.05 mm -> flatness 0.07 mm`\n")) << comment;
  EXPECT_TRUE(contains(comment, "**: 1 requirement differs; ")) << comment;
  EXPECT_LE(std::count(comment.begin(), comment.end(), '\n'), 20) << comment;
}

// Sizes of targets and of zones, too.
TEST_F(RequirementsCommand, KeepsTheUnitOfTheFileInWords) {
  const std::string target = step_target(1100, "1", {10, 10, 20}) +
                             "#1140=DATUM('','',#10,.F.,'A');\n#1141=SHAPE_ASPECT_RELATIONSHIP('','',#1100,#1140);\n";
  const std::string profile = step_length(1200, "0.4", "") + step_length(1201, "0.3", "") +
                              step_aspect(1202, top_face) +
                              "#1204=(GEOMETRIC_TOLERANCE('','',#1200,#1202)SURFACE_PROFILE_TOLERANCE()"
                              "UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE(#1201));\n";
  const Outcome listed = run({"requirements", "box.step"}, target + profile, true);
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_TRUE(contains(listed.out, "datum target A1, circle, target diameter 4 in; face")) << listed.out;
  EXPECT_TRUE(contains(listed.out, "surface profile 0.4 in, unequally disposed 0.3 in; face")) << listed.out;
  EXPECT_TRUE(contains(run({"requirements", "box.step"}, target + profile).out, "target diameter 4 mm; face"));
}

// A block of 40 x 30 x 20 mm whose only requirement is about all of it: no face is needed.
TEST(RequirementsOfMeshes, WordsOfGltfAreNotesOfTheSheet) {
  const std::string block =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":168,"uri":"data:application/octet-stream;base64,)"
      R"(AAAAAAAAAAAAAAAACtcjPQAAAAAAAAAACtcjPY/C9TwAAAAAAAAAAI/C9TwAAAAAAAAAAAAAAAAK16M8CtcjPQAAAAAK16M8Ctcj)"
      R"(PY/C9TwK16M8AAAAAI/C9TwK16M8AAADAAIAAAACAAEABAAFAAYABAAGAAcAAAABAAUAAAAFAAQAAQACAAYAAQAGAAUAAgADAAcA)"
      R"(AgAHAAYAAwAAAAQAAwAEAAcA"}],"bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,)"
      R"("byteLength":72}],"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0)"
      R"(,0,0],"max":[0.04,0.03,0.02]},{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],"mes)"
      R"(hes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"nodes":[{"mesh":0}],"scenes":[{"n)"
      R"(odes":[0],"extras":{"note":"Break sharp edges"}}],"scene":0})";
  const Folder folder;
  folder.file("block.gltf", block);
  const Outcome listed = epura({"requirements", "block.gltf"}, folder / "");
  if (contains(listed.err, "install the package")) GTEST_SKIP() << "there is no importer of glTF";
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_TRUE(contains(listed.out, "scene 0.extras.note note 'Break sharp edges'; no face")) << listed.out;
  const Outcome drawn = epura({"draw", "block.gltf", "--views", "front,top", "--pmi", "all", "--sheet", "A4", "-o",
                               "a.svg", "--svg-text", "text"},
                              folder / "");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "all 1 requirements of the models are drawn")) << drawn.err;
  EXPECT_TRUE(contains(read_file(folder / "a.svg"), "Break sharp edges"));
}

}  // namespace
}  // namespace epura::test::requirements_command_test
