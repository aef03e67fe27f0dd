// SPDX-License-Identifier: Apache-2.0
// What people are used to of command lines, and what they mean by words that are none.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::habits_test {
namespace {

class Habits : public testing::Test {
 protected:
  Folder folder;

  Outcome draw(std::vector<std::string> options) {
    options.insert(options.begin(), {"draw", sample("bracket.obj")});
    return epura(options, folder / "");
  }
  std::string drawn(std::vector<std::string> options) {
    options.insert(options.end(), {"-o", "x.svg"});
    const Outcome run = draw(options);
    EXPECT_EQ(run.code, 0) << run.err;
    return read_file(folder / "x.svg");
  }
};

TEST_F(Habits, TheLastOfARepeatedOptionCounts) {
  const std::string solid = drawn({"--hidden", "solid", "--portrait"});
  EXPECT_EQ(drawn({"--hidden", "none", "--portrait", "--hidden", "solid"}), solid);
  EXPECT_EQ(drawn({"--hidden=dashed", "--hidden=solid", "--portrait"}), solid);
  EXPECT_NE(drawn({"--hidden", "none", "--portrait"}), solid);
}

TEST_F(Habits, AnOptionIsNoValueOfAnother) {
  const Outcome run = draw({"--dimensions", "-o", "x.pdf"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--dimensions: needs a value, but '-o' is an option")) << run.err;
  EXPECT_EQ(drawn({"--near", "-5"}), drawn({"--near=-5"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "x.pdf"));
}

TEST_F(Habits, BlanksBesideCommasDoNotCount) {
  EXPECT_EQ(drawn({"--views", "front, top ,left"}), drawn({"--views", "front,top,left"}));
  EXPECT_EQ(drawn({"--edges", "contour, crease"}), drawn({"--edges", "contour,crease"}));
}

TEST_F(Habits, PapersHaveTheNamesOfPrinters) {
  for (const auto& [name, size] : {std::pair("letter", "ANSI-A"),
                                   {"Tabloid", "ANSI-B"},
                                   {"ledger", "ANSI-B"},
                                   {"ANSI C", "ANSI-C"},
                                   {"ANSI auto", "ANSI-auto"}})
    EXPECT_EQ(drawn({"--sheet", name}), drawn({"--sheet", size})) << name;
}

TEST_F(Habits, ShortNamesOfProjections) {
  for (const auto& [name, full] : {std::pair("iso", "isometric"), std::pair("perspective", "two-point")}) {
    const Outcome run = draw({"--projection", name, "-o", "x.json"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(contains(read_file(folder / "x.json"), "\"" + std::string(full) + "\""));
  }
}

TEST_F(Habits, WordsOfOtherProgramsHaveAHint) {
  const auto expect = [&](const Outcome& run, const std::string& hint) {
    EXPECT_EQ(run.code == 2 || run.code == 3, true) << run.err;
    EXPECT_TRUE(contains(run.err, hint)) << run.err;
  };
  expect(draw({"--dims", "overall", "-o", "x.svg"}), "did you mean '--dimensions'?");
  expect(draw({"--colour", "red", "-o", "x.svg"}), "did you mean '--style'?");
  expect(draw({"--projection", "side", "-o", "x.svg"}), "write left or right");
  expect(draw({"--projection", "cavalier:45", "-o", "x.svg"}), "'epura plugins cavalier' lists them");
  expect(epura({"part.stl"}, folder / ""), "write 'epura draw part.stl -o drawing.pdf'");
}

TEST_F(Habits, UnknownOptionsNameTheNearest) {
  const Outcome run = draw({"--qqqqqqqqqqqqqqqqqqqqqq", "-o", "x.svg"});
  EXPECT_EQ(run.code, 2);
  const std::string list = "the nearest are: ";
  ASSERT_TRUE(contains(run.err, list)) << run.err;
  const std::string named = run.err.substr(run.err.find(list));
  EXPECT_EQ(std::count(named.begin(), named.end(), ','), 2) << named;
}

}  // namespace
}  // namespace epura::test::habits_test
