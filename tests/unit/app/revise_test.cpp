// SPDX-License-Identifier: Apache-2.0
// epura draw --revise: clouds and a row in the table of revisions for what differs from an older version.
#include <gtest/gtest.h>

#include <regex>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "step_box.hpp"

namespace epura::test::revise_test {
namespace {

// A block with a step, whose height is given.
std::string block(double step) {
  const std::string z = std::to_string(step);
  return "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 20\nv 20 0 20\nv 20 30 20\nv 0 30 20\n"
         "v 20 0 " +
         z + "\nv 40 0 " + z + "\nv 40 30 " + z + "\nv 20 30 " + z +
         "\n"
         "f 1 4 3 2\nf 5 6 7 8\nf 9 10 11 12\nf 1 2 10 9 6 5\nf 4 8 7 12 11 3\nf 1 5 8 4\nf 2 3 11 10\nf 6 9 12 7\n";
}

class Revise : public testing::Test {
 protected:
  Revise() { folder_.file("old.obj", block(8)), folder_.file("new.obj", block(12)); }
  Outcome draw(std::vector<std::string> more) {
    std::vector<std::string> words{"draw", "--views", "front,top,left", "--dimensions", "auto", "--sheet",
                                   "A3",   "-o",      "a.svg",          "--svg-text",   "text"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }
  [[nodiscard]] std::string svg() const { return read_file(folder_ / "a.svg"); }
  Folder folder_;
};

TEST_F(Revise, MarksWhatDiffersAndSaysItInTheTable) {
  const Outcome drawn = draw({"new.obj", "--revise", "old.obj", "--revision", "B"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "revision B: lines of front, left; 2 clouds")) << drawn.err;
  EXPECT_TRUE(contains(svg(), "sheet-clouds"));
  EXPECT_TRUE(contains(svg(), ">lines of front, left<")) << "the row";
  EXPECT_FALSE(contains(svg(), ">...<"));
  // The edge of the step and its height are in the cloud of the front view, whose triangle has the index.
  const std::string clouds = svg().substr(svg().find("sheet-clouds"));
  EXPECT_TRUE(contains(clouds, ">B<"));
}

// A height between bottom and top, with its upper deviation.
std::string box(const std::string& height, const std::string& upper) {
  return step_box({40, 30, std::stod(height)},
                  step_aspect(1000, bottom_face) + step_aspect(1002, top_face) +
                      "#1004=DIMENSIONAL_LOCATION('linear distance','',#1000,#1002);\n" +
                      step_length(1010, height, "nominal value") + step_values(1012, 1004, "#1010") +
                      step_length(1014, "-0.1", "") + step_length(1015, upper, "") +
                      "#1016=TOLERANCE_VALUE(#1014,#1015);\n#1017=PLUS_MINUS_TOLERANCE(#1016,#1004);\n");
}

TEST_F(Revise, TheTableSaysWhichRequirementsHaveChanged) {
  folder_.file("old.step", box("20.", "0.1"));
  folder_.file("new.step", box("20.", "0.3"));
  const Outcome drawn = draw({"new.step", "--revise", "old.step"});
  if (contains(drawn.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "revision A: linear distance 20 ±0.1 mm -> -0.1/+0.3 mm; 1 cloud\n")) << drawn.err;
  EXPECT_TRUE(contains(svg(), ">linear distance 20 ±0.1 mm -&gt; -0.1/+0.3 mm<")) << "the row";
  EXPECT_FALSE(contains(svg(), ">...<"));
}

// The older one is drawn at a given scale, which asks for other facets.
TEST_F(Revise, EqualVersionsOfRoundPartsHaveNoRevision) {
  const std::string part = EPURA_TEST_SAMPLES "/step/clamp.step";
  const Outcome drawn = epura({"draw", part, "--dimensions", "auto", "--revise", part, "-o", "a.svg"}, folder_ / "");
  if (contains(drawn.err, "install the package")) GTEST_SKIP() << "there is no importer of STEP";
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "nothing differs from " + part + ": no revision is marked")) << drawn.err;
}

TEST_F(Revise, EqualVersionsHaveNoRevision) {
  const Outcome drawn = draw({"new.obj", "--revise", "new.obj"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "nothing differs from new.obj: no revision is marked")) << drawn.err;
  const std::string revised = svg();
  EXPECT_FALSE(contains(revised, "sheet-clouds"));
  EXPECT_EQ(draw({"new.obj"}).code, 0);
  EXPECT_TRUE(revised == svg()) << "has no row of a revision";
}

TEST_F(Revise, TheIndexFollowsThatOfTheLastRow) {
  const std::string scene =
      "[[model]]\nfile = \"new.obj\"\n[[view]]\nprojection = \"front\"\n"
      "[[revision]]\nrevision = \"C\"\ntext = \"first\"\n";
  folder_.file("old.toml", std::regex_replace(scene, std::regex("new.obj"), "old.obj"));
  folder_.file("new.toml", scene);
  const Outcome drawn =
      epura({"draw", "new.toml", "--revise", "old.toml", "-o", "a.svg", "--svg-text", "text"}, folder_ / "");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "revision D: lines of front; 1 cloud")) << drawn.err;
  EXPECT_TRUE(contains(svg(), ">first<"));
  EXPECT_TRUE(contains(svg(), ">D<"));
}

TEST_F(Revise, WhatCannotBeComparedIsRefused) {
  const Outcome two = draw({"new.obj", "old.obj", "--revise", "old.obj"});
  EXPECT_EQ(two.code, 2);
  EXPECT_TRUE(contains(two.err, "--revise: compares one model or scene file, but there are 2")) << two.err;
  const Outcome none = draw({"new.obj", "--revise", "none.obj"});
  EXPECT_EQ(none.code, 2);
  EXPECT_TRUE(contains(none.err, "none.obj")) << none.err;
  const Outcome over = draw({"new.obj", "--revise", "a.svg"});
  EXPECT_EQ(over.code, 2) << over.err;
}

}  // namespace
}  // namespace epura::test::revise_test
