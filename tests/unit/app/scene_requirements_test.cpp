// SPDX-License-Identifier: Apache-2.0
// Requirements that a scene file states of features: drawn, and in the ledger, as those of model files.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::scene_requirements_test {
namespace {

class SceneRequirements : public testing::Test {
 protected:
  // The flange of the samples: discs of 100 and 60 with eight holes of 18 about a bore.
  Outcome draw(const std::string& requirements, std::vector<std::string> more = {}) {
    std::filesystem::copy_file(sample("flange.obj"), folder_ / "flange.obj",
                               std::filesystem::copy_options::overwrite_existing);
    write_file(
        folder_ / "a.toml",
        "views = [\"front\", \"top\"]\nmodel = {file = \"flange.obj\"}\nsheet = {size = \"A3\"}\n" + requirements);
    std::vector<std::string> words{"draw", "a.toml", "-o", "a.svg", "-o", "a.json", "--svg-text", "text"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }
  [[nodiscard]] int says(const std::string& text) const {
    const std::string svg = read_file(folder_ / "a.svg"), whole = ">" + text + "<";
    int count = 0;
    for (std::size_t at = svg.find(whole); at != std::string::npos; at = svg.find(whole, at + 1)) ++count;
    return count;
  }
  [[nodiscard]] std::vector<Json> ledger() const {
    return JsonReader(read_file(folder_ / "a.json")).read()["report"]["requirements"].items;
  }

  Folder folder_;
};

const std::string bore =
    "[[requirement]]\ntype = \"diameter\"\nfeature = \"hole 1\"\nvalue = \"18.0\"\ntolerance = \"+0.2 -0.1\"\n";

TEST_F(SceneRequirements, AreDrawnAndInTheLedger) {
  const Outcome drawn = draw(bore +
                                 "[[requirement]]\ntype = \"datum\"\nfeature = \"face 1\"\nletter = \"A\"\n"
                                 "[[requirement]]\ntype = \"position\"\nname = \"holes\"\nfeature = \"hole 2\"\n"
                                 "zone = \"Ø0.25 M\"\ndatums = \"A\"\n",
                             {"--balloons", "characteristics"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "all 3 requirements of the models are drawn")) << drawn.err;
  EXPECT_EQ(says("⌀18.0 "), 1);
  EXPECT_EQ(says("+0.2"), 1);
  EXPECT_EQ(says("⌀0.25"), 1);
  EXPECT_EQ(says("A"), 4) << "of the datum, the position, and the border of the sheet twice";
  const std::vector<Json> rows = ledger();
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["id"].text, "requirement 1");
  EXPECT_EQ(rows[0]["what"].text, "diameter 18.0 -0.1/+0.2 mm");
  EXPECT_EQ(rows[0]["characteristic"].text, "1");
  EXPECT_EQ(rows[1]["kind"].text, "datum");
  EXPECT_EQ(rows[2]["id"].text, "holes");
  EXPECT_EQ(rows[2]["what"].text, "position 0.25 mm to A, cylindrical or circular, maximum material requirement");
  for (const Json& row : rows) EXPECT_EQ(row["sheet_zone"].text.size(), 2U);
}

// The ledger of a scene has the same rows as its drawing, in each of its formats.
TEST_F(SceneRequirements, AreListedWithoutADrawingToo) {
  ASSERT_EQ(draw(bore).code, 0);
  const Outcome listed = epura(
      {"requirements", "a.toml", "--drawing", "a.json", "--json", "l.json", "--as9102", "l.csv", "--qif", "l.qif"},
      folder_ / "");
  EXPECT_EQ(listed.code, 0) << listed.err;
  EXPECT_TRUE(contains(listed.out, "requirement 1 diameter 18.0 -0.1/+0.2 mm")) << listed.out;
  const Json model = JsonReader(read_file(folder_ / "l.json")).read()["models"].items.at(0);
  EXPECT_TRUE(contains(model["name"].text, "flange.obj"));
  const Json row = model["requirements"].items.at(0);
  EXPECT_EQ(row["characteristic"].text, "1");
  EXPECT_EQ(row["view"].text, ledger()[0]["view"].text);
  EXPECT_FALSE(row["faces"].items.empty());
  EXPECT_TRUE(contains(read_file(folder_ / "l.csv"), "diameter 18.0 -0.1/+0.2 mm"));
  EXPECT_TRUE(contains(read_file(folder_ / "l.qif"), ">18</TargetValue>"));
}

TEST_F(SceneRequirements, AFitAndADistanceAreThoseOfTheModel) {
  const Outcome drawn = draw(
      "[[requirement]]\ntype = \"diameter\"\nfeature = \"hole 1\"\ntolerance = \"H8\"\n"
      "[[requirement]]\ntype = \"linear distance\"\nfeature = \"hole 1\"\nto = \"hole 1\"\n");
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_EQ(says("⌀18 H8"), 1);
  EXPECT_TRUE(contains(drawn.err, "requirement 2 linear distance")) << drawn.err;
}

TEST_F(SceneRequirements, WhatTheModelIsNotIsToldAndNotDrawn) {
  const Outcome drawn = draw("[[requirement]]\ntype = \"diameter\"\nfeature = \"hole 1\"\nvalue = \"17\"\n");
  EXPECT_EQ(drawn.code, 1) << drawn.err;
  EXPECT_TRUE(contains(drawn.err, "requirement 1 diameter 17 mm: the model measures 18 at its faces")) << drawn.err;
  EXPECT_EQ(draw("[[requirement]]\ntype = \"diameter\"\nfeature = \"hole 1\"\nvalue = \"17\"\n",
                 {"--allow-missing-requirements"})
                .code,
            0);
}

// Three distances of a block are what holds its faces: without one of them, a face is free.
TEST_F(SceneRequirements, AreEquationsOfTheAccountant) {
  folder_.file("block.obj",
               "v 0 0 0\nv 40 0 0\nv 40 30 0\nv 0 30 0\nv 0 0 20\nv 40 0 20\nv 40 30 20\nv 0 30 20\n"
               "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const auto distance = [](const char* from, const char* to, const char* value) {
    return std::string("[[requirement]]\ntype = \"linear distance\"\nfeature = \"face ") + from + "\"\nto = \"face " +
           to + "\"\nvalue = \"" + value + "\"\n";
  };
  const auto judge = [&](const char* command, const std::string& requirements) {
    folder_.file("b.toml", "views = [\"front\", \"top\"]\nmodel = {file = \"block.obj\"}\nsheet = {size = \"A3\"}\n" +
                               requirements);
    return epura({command, "b.toml"}, folder_ / "");
  };
  const std::string two = distance("3", "4", "20.0") + distance("2", "5", "30.0");
  const Outcome free = judge("lint", two);
  EXPECT_EQ(free.code, 1);
  EXPECT_TRUE(contains(free.out, "plane face 6 of 600 mm² at (40, 15, 10): can move along x")) << free.out;
  EXPECT_TRUE(contains(free.out, "5 of 6 faces held by dimensions")) << free.out;
  const Outcome undefined = judge("define", two);
  EXPECT_EQ(undefined.code, 1);
  EXPECT_TRUE(contains(undefined.out, "5 of 6 faces are found again")) << undefined.out;
  const std::string three = two + distance("1", "6", "40.0");
  const Outcome held = judge("lint", three);
  EXPECT_EQ(held.code, 0) << held.out;
  EXPECT_TRUE(contains(held.out, "requirements: 3 of 3 are drawn")) << held.out;
  EXPECT_TRUE(contains(held.out, "6 of 6 faces held by dimensions")) << held.out;
  const Outcome defined = judge("define", three);
  EXPECT_EQ(defined.code, 0) << defined.out;
  EXPECT_TRUE(contains(defined.out, "6 of 6 faces are found again")) << defined.out;
}

/// What is wrong, and what is said of it.
struct Wrong {
  std::string lines, message;
};

TEST_F(SceneRequirements, WrongOnesAreRefusedWithTheirPlace) {
  const std::vector<Wrong> all{
      {"type = \"diametre\"\nfeature = \"hole 1\"", "a.toml:5:8: there is no type of requirement 'diametre'"},
      {"type = \"diameter\"", "[[requirement]] lacks 'feature'"},
      {"type = \"diameter\"\nfeature = \"hole 99\"", "a.toml:6:11: 'flange' has no hole 99"},
      {"type = \"diameter\"\nfeature = {point = [0, 0, 0]}", "a requirement is about a feature, not a point"},
      {"type = \"diameter\"\nfeature = \"hole 1\"\nto = \"hole 2\"", "a requirement of type 'diameter' has no 'to'"},
      {"type = \"angle\"\nfeature = \"face 1\"", "a requirement of type 'angle' lacks 'to'"},
      {"type = \"flatness\"\nfeature = \"face 1\"", "a requirement of type 'flatness' lacks 'zone'"},
      {"type = \"flatness\"\nfeature = \"face 1\"\nzone = \"0.1\"\ndatums = \"A\"", "has no 'datums'"},
      {"type = \"parallelism\"\nfeature = \"face 1\"\nzone = \"0.1\"", "lacks 'datums'"},
      {"type = \"parallelism\"\nfeature = \"face 1\"\nzone = \"0.1\"\ndatums = \"C\"",
       "there is no datum C, to which the parallelism refers"},
      {"type = \"diameter\"\nfeature = \"hole 1\"\ntolerance = \"±0.1\"", "deviations need the value"},
      {"type = \"datum\"\nfeature = \"face 1\"", "a requirement of type 'datum' lacks 'letter'"},
      {"type = \"flatness\"\nfeature = \"face 1\"\nzone = \"0.1 P 5\"", "requirements have no modifier 'P'"},
      {"type = \"diameter\"\nfeature = \"hole 1\"\nvalue = \"wide\"", "a.toml:7:9: 'wide' is not a value"},
      {"type = \"diameter\"\nfeature = \"hole 1\"\ntolerance = \"Z99\"", "a.toml:7:13: "}};
  for (const Wrong& one : all) {
    const Outcome drawn = draw("[[requirement]]\n" + one.lines + "\n");
    EXPECT_EQ(drawn.code, 2) << one.lines << drawn.err;
    EXPECT_TRUE(contains(drawn.err, one.message)) << one.message << "\n" << drawn.err;
  }
}

}  // namespace
}  // namespace epura::test::scene_requirements_test
