// SPDX-License-Identifier: Apache-2.0
// Exploded views: the drawing of models that lie apart in their files.
#include <gtest/gtest.h>

#include <string>

#include "../output/json_reader.hpp"
#include "base/text.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::exploded_test {
namespace {

class Exploded : public testing::Test {
 protected:
  Folder folder;

  Outcome draw(const std::string& scene, const std::string& file, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"draw", folder.file("scene.toml", scene), "-o", file + ".json", "-o",
                                     file + ".svg", "--svg-text", "text"});
    return epura(options, folder / "");
  }
};

// A box of 20 x 10 x 10, as an object with vertices of its own or with those before it.
std::string box(const std::string& name, double x, double y, double z, int first) {
  std::string text = "o " + name + "\n";
  for (int corner = 0; corner < 8; ++corner)
    text += "v " + format_number(x + (corner % 4 == 1 || corner % 4 == 2 ? 20 : 0)) + " " +
            format_number(y + (corner % 4 >= 2 ? 10 : 0)) + " " + format_number(z + (corner >= 4 ? 10 : 0)) + "\n";
  const auto face = [&](int a, int b, int c, int d) {
    text += "f";
    for (const int v : {a, b, c, d}) text += " " + std::to_string(first + v);
    text += "\n";
  };
  face(3, 2, 1, 0), face(4, 5, 6, 7), face(0, 1, 5, 4), face(1, 2, 6, 5), face(2, 3, 7, 6), face(3, 0, 4, 7);
  return text;
}

const std::string sheet = "[sheet]\nsize = 'A3'\nscale = '1:1'\n";
const std::string views = "[[view]]\nprojection = 'isometric'\nhidden = 'dashed'\n[[view]]\nprojection = 'top'\n";

// The same bytes as a file with the bodies where they are moved.
TEST_F(Exploded, IsTheDrawingOfBodiesThatLieApart) {
  folder.file("a.obj", box("base", 0, 0, 0, 1) + box("lid", 5, 2, 10, 9) + box("side", 20, 3, 4, 17));
  folder.file("b.obj", box("base", 0, 0, 0, 1) + box("lid", 5, 2, 35, 9) + box("side", 32, 0, 4, 17));
  const auto scene = [](const std::string& file) { return "[[model]]\nfile = '" + file + "'\n" + sheet + views; };
  const Outcome exploded = draw(scene("a.obj") +
                                    "[[explode]]\nmatch = 'l*'\nmove = [0, 0, 25]\n[[explode]]\nmatch = 'side'\nmove = "
                                    "[10, 0, 0]\n[[explode]]\nmatch = 'side'\nmove = [2, -3, 0]\n",
                                "a");
  ASSERT_EQ(exploded.code, 0) << exploded.err;
  ASSERT_EQ(draw(scene("b.obj"), "b").code, 0);
  EXPECT_TRUE(read_file(folder / "a.svg") == read_file(folder / "b.svg"));
}

// Bodies that share vertices get their own.
TEST_F(Exploded, SeparatesBodiesThatShareVertices) {
  std::string text = box("base", 0, 0, 0, 1);
  // A lid on the upper corners of the base, which are vertices 5 to 8.
  text +=
      "v 0 0 20\nv 20 0 20\nv 20 10 20\nv 0 10 20\no lid\nf 8 7 6 5\nf 9 10 11 12\nf 5 6 10 9\nf 6 7 11 10\n"
      "f 7 8 12 11\nf 8 5 9 12\n";
  folder.file("a.obj", text);
  folder.file("b.obj", box("base", 0, 0, 0, 1) + box("lid", 0, 0, 40, 9));
  const auto scene = [](const std::string& file) { return "[[model]]\nfile = '" + file + "'\n" + sheet + views; };
  const Outcome run = draw(scene("a.obj") + "[[explode]]\nmatch = 'lid'\nmove = [0, 0, 30]\n", "a");
  ASSERT_EQ(run.code, 0) << run.err;
  ASSERT_EQ(draw(scene("b.obj"), "b").code, 0);
  const Outcome compared = epura({"compare", "a.svg", "b.svg"}, folder / "");
  EXPECT_EQ(compared.code, 0) << compared.out;
}

TEST_F(Exploded, ConcernsTheViewsItNames) {
  folder.file("a.obj", box("base", 0, 0, 0, 1) + box("lid", 5, 2, 10, 9));
  const std::string scene =
      "[[model]]\nfile = 'a.obj'\n" + sheet +
      "[[section]]\nname = 'A'\npoint = [0, 5, 0]\n[[view]]\nprojection = 'front'\n[[view]]\nname "
      "= 'apart'\nprojection = 'front'\nsection = 'A'\n[[view]]\nprojection = 'top'\n"
      "[[explode]]\nview = 'apart'\nmatch = 'lid'\nmove = [0, 0, 30]\ntrace = true\n";
  const Outcome run = draw(scene, "a", {"--dimensions", "overall"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = JsonReader(read_file(folder / "a.json")).read();
  const auto height = [&](std::size_t view) {
    double min = 1e9, max = -1e9;
    for (const Json& segment : json["views"].items[view]["segments"].items)
      for (const char* end : {"from", "to"}) {
        min = std::min(min, segment[end].items[1].number());
        max = std::max(max, segment[end].items[1].number());
      }
    return max - min;
  };
  EXPECT_NEAR(height(0), 20, 1e-6);
  EXPECT_NEAR(height(1), 50, 1e-6);
  EXPECT_EQ(json["views"].items[1]["cut_faces"].items.size(), 2U);
  const std::string svg = read_file(folder / "a.svg");
  EXPECT_TRUE(contains(svg, "apart-trace\""));
  EXPECT_TRUE(contains(svg, ">20<"));
  EXPECT_FALSE(contains(svg, ">50<"));
}

// The largest body stays; the others move by the factor of their distance along an axis.
TEST_F(Exploded, OutwardsMovesAllButTheLargest) {
  folder.file("a.obj", box("base", 0, 0, 0, 1) +
                           "v 5 3 10\nv 8 3 10\nv 8 6 10\nv 5 6 10\nv 5 3 16\nv 8 3 16\nv 8 6 16\n"
                           "v 5 6 16\no pin\nf 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\n"
                           "f 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n");
  const Outcome run = epura({"draw", "a.obj", "--projection", "front", "--explode", "2", "--sheet", "A4", "--scale",
                             "1:1", "--dimensions", "overall", "--svg-text", "text", "-o", "a.svg"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  // The middles were 8 apart, so the pin ends at 16 + 2 * 8.
  EXPECT_TRUE(contains(read_file(folder / "a.svg"), ">32<"));
}

TEST_F(Exploded, ThatMakesNoSenseIsRefused) {
  folder.file("a.obj", box("base", 0, 0, 0, 1) + box("lid", 5, 2, 10, 9));
  const auto expect = [&](const std::string& explode, const std::string& what) {
    const Outcome run = draw("[[model]]\nfile = 'a.obj'\n" + views + explode, "a");
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, what)) << run.err;
  };
  expect("[[explode]]\nmatch = 'bolt*'\nmove = [0, 0, 1]\n", "no body or model is called 'bolt*'");
  expect("[[explode]]\nmatch = 'lid'\n", "8:1: [[explode]] has no move");
  expect("[[explode]]\nfactor = 1\nmove = [0, 0, 1]\n", "[[explode]] has both a move and a factor");
  expect("[[explode]]\nfactor = 1\nview = 'tip'\n", "there is no view 'tip'\n  hint: did you mean 'top'?");
  expect(
      "[[explode]]\nfactor = 1\nview = 'top'\n[[dimension]]\ntype = 'linear'\nview = 'top'\ndirection = 'horizontal'\n"
      "from = [0, 0]\nto = [0, 1]\n",
      "view 'top' is exploded and has no dimensions");
}

// Distances between bodies that are moved apart are not those of the assembly.
TEST_F(Exploded, HasNoAutomaticDimensions) {
  folder.file("a.obj", box("base", 0, 0, 0, 1) + box("lid", 5, 2, 10, 9));
  const std::string model = "[[model]]\nfile = 'a.obj'\n", automatic = "[[dimension]]\ntype = 'auto'\n";
  const std::string moved = "[[explode]]\nmatch = 'lid'\nmove = [0, 0, 25]\n";
  const Outcome all = draw(model + views + moved + automatic, "a");
  EXPECT_EQ(all.code, 2);
  EXPECT_TRUE(contains(all.err, "distances between parts are not those of the assembly")) << all.err;
  const Outcome one = draw(model + views + moved + "view = 'isometric'\n" + automatic, "a");
  EXPECT_EQ(one.code, 0) << one.err;
}

// Bodies without names have those of the parts list in patterns.
TEST_F(Exploded, BodiesAreKnownByTheNamesOfThePartsList) {
  const std::string bodies = box("", 0, 0, 0, 1) +
                             "v 40 0 0\nv 50 0 0\nv 50 10 0\nv 40 10 0\nv 40 0 9\nv 50 0 9\nv 50 10 9\nv 40 10 9\n"
                             "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";
  folder.file("two.obj", bodies.substr(bodies.find('\n') + 1));
  const std::string scene = "[[model]]\nfile = 'two.obj'\n" + sheet + "[[view]]\nprojection = 'front'\n";
  const auto width = [&](const std::string& file) {
    double min = 1e9, max = -1e9;
    const Json json = JsonReader(read_file(folder / file)).read();
    for (const Json& segment : json["views"].items[0]["segments"].items)
      for (const char* end : {"from", "to"}) {
        min = std::min(min, segment[end].items[0].number());
        max = std::max(max, segment[end].items[0].number());
      }
    return max - min;
  };
  const Outcome all = draw(scene, "a");
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_NEAR(width("a.json"), 50, 1e-6);
  const Outcome one = draw(scene + "[[style]]\nmatch = 'two 2'\ndrawn = false\n", "b");
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_FALSE(contains(one.err, "no body or model")) << one.err;
  EXPECT_NEAR(width("b.json"), 20, 1e-6);
  const Outcome apart = draw(scene + "[[explode]]\nmatch = 'two 2'\nmove = [30, 0, 0]\n", "c");
  ASSERT_EQ(apart.code, 0) << apart.err;
  EXPECT_NEAR(width("c.json"), 80, 1e-6);
  const Outcome wrong = draw(scene + "[[style]]\nmatch = 'tow 2'\ndrawn = false\n", "d");
  EXPECT_TRUE(contains(wrong.err, "no body or model is called 'tow 2'")) << wrong.err;
  EXPECT_TRUE(contains(wrong.err, "did you mean 'two 2'?")) << wrong.err;
}

}  // namespace
}  // namespace epura::test::exploded_test
