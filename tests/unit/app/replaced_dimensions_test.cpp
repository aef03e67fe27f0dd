// SPDX-License-Identifier: Apache-2.0
// Dimensions of a scene that take the places of automatic ones.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/text.hpp"
#include "drawn_texts.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::replaced_dimensions_test {
namespace {

class ReplacedDimensions : public testing::Test {
 protected:
  Folder folder;

  // The texts of a part with automatic dimensions and a given one.
  Words texts_with(const std::string& model, const std::string& given) {
    const std::string scene =
        "[[model]]\nfile = \"" + model +
        ".obj\"\n[[view]]\nprojection = \"front\"\n[[view]]\nprojection = \"top\"\n"
        "[[view]]\nprojection = \"left\"\n[sheet]\nsize = \"A3\"\n[[dimension]]\ntype = \"auto\"\n"
        "[[dimension]]\n";
    const Outcome run = epura({"draw", folder.file("scene.toml", scene + given), "-o", "x.svg"}, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return sorted(dimensions_in(read_file(folder / "x.svg")));
  }
};

std::string at(const std::string& key, const std::string& point) { return key + " = {point = [" + point + "]}\n"; }

// A dimension of the scene takes the place of the automatic one: on the circle, on one of several equal holes, as a
// length across a shaft, between the same places. The text of the automatic one stays.
TEST_F(ReplacedDimensions, AreThereOnce) {
  const auto hole = [](double r, double depth) { return stepped_hole({{r, 20}, {r, 20 - depth}}); };
  folder.file("one.obj", plate({50, 30}, 1, 1, 20, hole(5, 12)));
  folder.file("four.obj", plate({40, 30}, 2, 2, 20, hole(4, 20)));
  folder.file("shaft.obj", shaft({{0, 1e-9}, {0, 20}, {10, 20}, {10, 14}, {50, 14}, {50, 1e-9}}));
  struct Case {
    std::string model, given;
    Words texts;
  };
  const std::string top = "view = \"top\"\n", front = "view = \"front\"\n";
  const std::vector<Case> cases{
      {"one",
       "type = \"diameter\"\ntolerance = \"H7\"\n" + top + at("at", "25, 20, 20"),
       {"50", "30", "20", "25", "15", "⌀10 H7 ↧12"}},
      {"one",
       "type = \"diameter\"\ntext = \"<> reamed\"\n" + top + at("at", "25, 20, 20"),
       {"50", "30", "20", "25", "15", "⌀10 reamed"}},
      {"one",
       "type = \"linear\"\ndirection = \"horizontal\"\ntolerance = \"±0.1\"\n" + top + at("from", "0, 0, 20") +
           at("to", "25, 15, 20"),
       {"50", "30", "20", "25 ±0.1", "15", "⌀10 ↧12"}},
      {"one",
       "type = \"linear\"\ndirection = \"vertical\"\ntolerance = \"±0.2\"\n" + front + at("from", "0, 0, 0") +
           at("to", "0, 0, 20"),
       {"50", "30", "20 ±0.2", "25", "15", "⌀10 ↧12"}},
      {"one",
       "type = \"linear\"\ndirection = \"vertical\"\ntext = \"(<>)\"\n" + front + at("from", "0, 0, 0") +
           at("to", "0, 0, 20"),
       {"50", "30", "20", "(20)", "25", "15", "⌀10 ↧12"}},
      {"four",
       "type = \"diameter\"\ntolerance = \"H7\"\n" + top + at("at", "24, 15, 20"),
       {"80", "60", "20", "4× ⌀8 H7", "20", "60", "15", "45"}},
      // A text that speaks of one hole says nothing of the other three.
      {"four",
       "type = \"diameter\"\ntext = \"<> reamed\"\n" + top + at("at", "24, 15, 20"),
       {"80", "60", "20", "4× ⌀8", "⌀8 reamed", "20", "60", "15", "45"}},
      {"four",
       "type = \"diameter\"\ntext = \"4× <> reamed\"\n" + top + at("at", "24, 15, 20"),
       {"80", "60", "20", "4× ⌀8 reamed", "20", "60", "15", "45"}},
      {"shaft",
       "type = \"linear\"\ndirection = \"vertical\"\ntext = \"⌀<>\"\ntolerance = \"h6\"\n" + front +
           at("from", "50, 0, -14") + at("to", "50, 0, 14"),
       {"50", "⌀40", "10", "⌀28 h6"}},
      {"shaft",
       "type = \"overall\"\ndirection = \"width\"\ntolerance = \"±0.3\"\n" + front,
       {"50 ±0.3", "⌀40", "10", "⌀28"}},
  };
  for (const Case& one : cases) EXPECT_EQ(texts_with(one.model, one.given), sorted(one.texts)) << one.given;
}

// Between two places, or two sides at one angle, of which automatic ones give both: one of them follows.
TEST_F(ReplacedDimensions, LeaveOneOfTwoToAnother) {
  folder.file("four.obj", plate({40, 30}, 2, 2, 20, stepped_hole({{4, 20}, {4, 0}})));
  EXPECT_EQ(
      texts_with("four", "type = \"linear\"\ndirection = \"horizontal\"\ntolerance = \"±0.05\"\nview = \"top\"\n" +
                             at("from", "20, 15, 20") + at("to", "60, 15, 20")),
      sorted({"80", "60", "20", "4× ⌀8", "20", "40 ±0.05", "15", "45"}));
  const double lean = 8 * sine(20) / cosine(20), apex = 40 + 20 * cosine(20) / sine(20);
  folder.file("dovetail.obj",
              block({{0, 0}, {80, 0}, {80, 40}, {60, 40}, {60 + lean, 32}, {20 - lean, 32}, {20, 40}, {0, 40}}, 12));
  EXPECT_EQ(texts_with("dovetail", "type = \"angular\"\ntolerance = \"±0.5\"\nview = \"front\"\n" +
                                       at("corner", "40, 0, " + format_number(apex)) +
                                       at("from", format_number(60 + lean) + ", 0, 32") +
                                       at("to", format_number(20 - lean) + ", 0, 32")),
            sorted({"80", "40", "12", "20", "60", "32", "70°", "40° ±0.5°"}));
}

}  // namespace
}  // namespace epura::test::replaced_dimensions_test
