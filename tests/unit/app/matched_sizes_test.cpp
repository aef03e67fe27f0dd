// SPDX-License-Identifier: Apache-2.0
// What a scene says of automatic sizes by their text.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::matched_sizes_test {
namespace {

class MatchedSizes : public testing::Test {
 protected:
  MatchedSizes() {
    const auto hole = [](double r, double depth) { return stepped_hole({{r, 20}, {r, 20 - depth}}); };
    folder.file("one.obj", plate({50, 30}, 1, 1, 20, hole(5, 12)));
    folder.file("four.obj", plate({40, 30}, 2, 2, 20, hole(4, 20)));
  }

  [[nodiscard]] Outcome draw(const std::string& model, const std::string& dimensions,
                             std::vector<std::string> more = {}) const {
    const std::string scene = "[[model]]\nfile = \"" + model +
                              ".obj\"\n[[view]]\nprojection = \"front\"\n[[view]]\nprojection = \"top\"\n"
                              "[[view]]\nprojection = \"left\"\n[sheet]\nsize = \"A3\"\n" +
                              dimensions;
    std::vector<std::string> words{"draw", folder.file("scene.toml", scene), "-o", "x.svg"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder / "");
  }
  [[nodiscard]] Words texts() const { return sorted(dimensions_in(read_file(folder / "x.svg"))); }

  const std::string automatic = "[[dimension]]\ntype = \"auto\"\n", wish = "[[dimension]]\nmatch = ";
  Folder folder;
};

TEST_F(MatchedSizes, GetWhatIsSaidOfThem) {
  struct Case {
    std::string model, said;
    Words texts;
  };
  const std::vector<Case> cases{
      {"one", "\"⌀10\"\ntolerance = \"H7\"\n", {"50", "30", "20", "25", "15", "⌀10 H7 ↧12"}},
      {"one",
       "\"Ø10*\"\ntolerance = \"H7\"\nlimits = true\n",
       {"50", "30", "20", "25", "15", "⌀10 H7 (", "10.015", "10.000", ") ↧12"}},
      {"one", "\"⌀10\"\ntext = \"<> reamed\"\n", {"50", "30", "20", "25", "15", "⌀10 ↧12 reamed"}},
      {"one", "\"30\"\ntolerance = \"+0.2 -0.1\"\n", {"50", "30 ", "+0.2", "-0.1", "20", "25", "15", "⌀10 ↧12"}},
      {"four", "\"4x ⌀8\"\ntolerance = \"H7\"\n", {"80", "60", "20", "4× ⌀8 H7", "20", "60", "15", "45"}},
      {"four", "\"60\"\ntolerance = \"±0.1\"\n", {"80", "60 ±0.1", "20", "4× ⌀8", "20", "60 ±0.1", "15", "45"}},
      {"four",
       "\"60\"\ntype = \"linear\"\ntolerance = \"±0.1\"\n",
       {"80", "60", "20", "4× ⌀8", "20", "60 ±0.1", "15", "45"}},
      {"four", "\"?0\"\nview = \"front\"\ntext = \"<> x\"\n", {"80 x", "60", "20 x", "4× ⌀8", "20", "60", "15", "45"}},
  };
  for (const Case& one : cases) {
    const Outcome run = draw(one.model, automatic + wish + one.said);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(contains(run.err, "no automatic size")) << run.err;
    EXPECT_EQ(texts(), sorted(one.texts)) << one.said;
  }
}

// As one dimension, whether it is automatic or given.
TEST_F(MatchedSizes, AreGivenOnTheCommandLine) {
  const Outcome run = draw("one", "", {"--dimensions", "auto", "--tolerance", "⌀10=H7", "--tolerance", "50=±0.1"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(texts(), sorted({"50 ±0.1", "30", "20", "25", "15", "⌀10 H7 ↧12"}));
  const Outcome wrong = draw("one", "", {"--dimensions", "auto", "--tolerance", "H7"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "for example ⌀8=H7")) << wrong.err;
}

// Places of a row become dimensions of their own; what is left of it stays a row.
TEST_F(MatchedSizes, LeaveRowsFromOneOrigin) {
  const std::string row = "[[dimension]]\ntype = \"auto\"\narrangement = \"ordinate\"\n";
  const Outcome run = draw("four", row + wish + "\"20\"\ntype = \"linear\"\ntolerance = \"±0.1\"\n");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(texts(), sorted({"80", "60", "20", "4× ⌀8", "20 ±0.1", "60", "0", "15", "45"}));
}

TEST_F(MatchedSizes, ThatAreNotThereAreTold) {
  const Outcome run = draw("one", automatic + wish + "\"⌀11\"\ntolerance = \"H7\"\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.err, "scene.toml:14:9: no automatic size is '⌀11'")) << run.err;
  EXPECT_TRUE(contains(run.err, "⌀10 ↧12")) << run.err;
  const Outcome elsewhere = draw("one", automatic + wish + "\"⌀10*\"\ntolerance = \"H7\"\nview = \"front\"\n");
  EXPECT_EQ(elsewhere.code, 1);
  EXPECT_TRUE(contains(elsewhere.err, "it is in view 'top', not in 'front'")) << elsewhere.err;
  const Outcome none = draw("one", wish + "\"⌀10\"\ntolerance = \"H7\"\n");
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(contains(none.err, "--dimensions")) << none.err;
  const Outcome option = draw("one", "", {"--dimensions", "auto", "--tolerance", "99=±1"});
  EXPECT_EQ(option.code, 1);
  EXPECT_TRUE(contains(option.err, "no automatic size is '99'")) << option.err;
}

TEST_F(MatchedSizes, RefuseWhatTheyCannotSay) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"tolerance = \"H7\"\n", "lacks 'type'"},
      {"match = \"⌀10\"\n", "nothing is said"},
      {"match = \"⌀10\"\ntype = \"auto\"\ntolerance = \"H7\"\n", "no single size is of type 'auto'"},
      {"match = \"⌀10\"\nat = {point = [25, 20, 20]}\ntolerance = \"H7\"\n", "sizes that have their places"},
      {"match = \"⌀10\"\nname = \"bore\"\n", "needs its view"},
  };
  for (const auto& [said, why] : cases) {
    const Outcome run = draw("one", automatic + "[[dimension]]\n" + said);
    EXPECT_EQ(run.code, 2) << said;
    EXPECT_TRUE(contains(run.err, why)) << run.err;
  }
}

}  // namespace
}  // namespace epura::test::matched_sizes_test
