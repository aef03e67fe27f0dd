// SPDX-License-Identifier: Apache-2.0
// `epura define`: the part is found again from the numbers on its sheets, or what is not.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"
#include "schema.hpp"

namespace epura::test::define_test {
namespace {

class Define : public testing::Test {
 protected:
  Outcome define(const std::string& obj, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"define", "--rebuild", folder_.file("part.obj", obj), "--json", "part.json"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }
  [[nodiscard]] Json found() const { return JsonReader(read_file(folder_ / "part.json")).read(); }

  Folder folder_;
};

// 60 x 40 x 10; its upper edge is cut off from (50, 10) to (60, 4).
const char* const sloped =
    "v 0 0 0\nv 60 0 0\nv 60 0 4\nv 50 0 10\nv 0 0 10\nv 0 40 0\nv 60 40 0\nv 60 40 4\nv 50 40 10\nv 0 40 10\n"
    "f 1 2 3 4 5\nf 10 9 8 7 6\nf 1 6 7 2\nf 2 7 8 3\nf 3 8 9 4\nf 4 9 10 5\nf 5 10 6 1\n";

// The part in two views with its overall sizes, and the beginning of a length in the front view.
const char* const front_length =
    "[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'top'\n[[dimension]]\n"
    "type = 'overall'\n[[dimension]]\ntype = 'linear'\nview = 'front'\ndirection = 'horizontal'\n";

TEST_F(Define, FindsAPartAgainFromItsNumbers) {
  const Outcome run = define(sloped);
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, "7 of 7 faces are found again from the numbers on the sheets")) << run.out;
  EXPECT_EQ(Schema(read_file(root() / "src/run/app/define.schema.json")).fault_of(found()), "");
  EXPECT_GT(found()["perturbed"].number(), 0.3);
  EXPECT_LT(found()["deviation"].number(), 1e-6);
  EXPECT_NEAR(found()["volume"].number(), 22800, 0.1);
}

TEST_F(Define, NamesFacesThatNothingHolds) {
  const Outcome run = define(sloped, {"--dimensions", "overall"});
  EXPECT_EQ(run.code, 1) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, "not defined: plane face 6 of 466.5 mm² at (55, 20, 7)")) << run.out;
  EXPECT_TRUE(contains(run.out, "6 of 7 faces are found again")) << run.out;
  ASSERT_EQ(found()["free"].items.size(), 1U);
  EXPECT_EQ(found()["free"].items[0]["face"].text, "6");
  EXPECT_EQ(found()["defined"].type, 'f');
}

// The number on the sheet counts, not that of the part.
TEST_F(Define, BelievesTexts) {
  folder_.file("part.obj", sloped);
  const std::string scene =
      std::string(front_length) +
      "from = {point = [0, 0, 10]}\nto = {point = [50, 0, 10]}\ntext = '51'\n[[dimension]]\ntype = 'linear'\n"
      "view = 'front'\ndirection = 'vertical'\nfrom = {point = [60, 0, 0]}\nto = {point = [60, 0, 4]}\n";
  const Outcome run =
      epura({"define", "--rebuild", folder_.file("a.toml", scene), "--json", "part.json"}, folder_ / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  // The slope is from (51, 10) to (60, 4). It is larger than the ends, and thus a datum: its middle, (55, 7), stays,
  // which is 0.5 along x from there.
  EXPECT_NEAR(found()["deviation"].number(), 0.5, 1e-6);
  EXPECT_NEAR(found()["volume"].number(), 24000 - 40 * 9 * 6 / 2, 0.1);
}

TEST_F(Define, NeedsNoOption) {
  const Outcome run = epura({"define", folder_.file("part.obj", sloped)}, folder_ / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, "7 of 7 faces are found again")) << run.out;
}

TEST_F(Define, TurnsAPartThatLiesAskew) {
  const Outcome run = epura({"define", folder_.file("part.obj", turned_about_z(sloped, 27))}, folder_ / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(run.err, "lies askew")) << run.err;
  EXPECT_TRUE(contains(run.out, "7 of 7 faces are found again")) << run.out;
}

// By what a reader finds on the sheet: no face begins or ends at 7 or 13.
TEST_F(Define, NamesDimensionsByTextAndView) {
  folder_.file("part.obj", sloped);
  const std::string scene =
      std::string(front_length) +
      "from = {point = [7, 0, 10]}\nto = {point = [13, 0, 10]}\n[[dimension]]\ntype = 'linear'\nview = 'top'\n"
      "direction = 'horizontal'\nfrom = {point = [0, 0, 10]}\nto = {point = [50, 0, 10]}\ntext = '51'\n";
  const std::string file = folder_.file("a.toml", scene);
  const Outcome run = epura({"define", "--rebuild", file}, folder_ / "");
  EXPECT_TRUE(contains(run.out, "cannot tell: what '6' in view 'front' measures")) << run.out << run.err;
  const Outcome lint = epura({"lint", file}, folder_ / "");
  EXPECT_TRUE(contains(lint.out, "nobody can tell what this says of them: '6' in view 'front'")) << lint.out;
  EXPECT_TRUE(contains(lint.out, "'51' in view 'top': the part has 50")) << lint.out;
}

TEST_F(Define, IsRefusedWhereItCannotTell) {
  const Outcome faceless = define(sloped, {"--surfaces", "mesh"});
  EXPECT_EQ(faceless.code, 2) << faceless.out;
  EXPECT_TRUE(contains(faceless.err, "only single parts with recognised faces")) << faceless.err;
}

}  // namespace
}  // namespace epura::test::define_test
