// SPDX-License-Identifier: Apache-2.0
// Dimensions from the command line and from scene files, to the file.
#include <gtest/gtest.h>

#include <regex>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::dimensions_test {
namespace {

using Words = std::vector<std::string>;

// The texts of a view's dimensions, each followed by a space.
std::string dimensions_in(const std::string& svg, const std::string& view) {
  const std::size_t begin =
      svg.find("-" + view + "-dimensions\" inkscape:groupmode=\"layer\" inkscape:label=\"dimensions\"");
  if (begin == std::string::npos) return {};
  const std::string layer = svg.substr(begin, svg.find("<g id=", begin) - begin);
  static const std::regex text("aria-label=\"([^\"]*)\"");
  std::string texts;
  for (std::sregex_iterator it(layer.begin(), layer.end(), text), end; it != end; ++it) texts += (*it)[1].str() + ' ';
  return texts;
}

class DimensionsOfProgram : public testing::Test {
 protected:
  Folder folder;

  std::string drawn(Words arguments) {
    arguments.insert(arguments.begin(), {"draw", "--allow-outside"});
    arguments.insert(arguments.end(), {"-o", "x.svg"});
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(contains(run.err, "beyond the paper")) << run.err;
    return read_file(folder / "x.svg");
  }
  std::string refused(Words arguments) {
    arguments.insert(arguments.begin(), {"draw", "--allow-outside"});
    arguments.insert(arguments.end(), {"-o", "x.svg"});
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 2) << run.err;
    return run.err;
  }
};

TEST_F(DimensionsOfProgram, OverallOnesEachOnceInTheClearestView) {
  const std::string svg =
      drawn({sample("bracket.obj"), "--views", "front,top,left,isometric", "--dimensions", "overall"});
  EXPECT_EQ(dimensions_in(svg, "front"), "80 75 ");
  EXPECT_EQ(dimensions_in(svg, "left"), "70 ");
  EXPECT_EQ(dimensions_in(svg, "top"), "");
  EXPECT_EQ(dimensions_in(svg, "isometric"), "");
}

TEST_F(DimensionsOfProgram, HaveRoomOnEverySheet) {
  for (const char* sheet : {"A4", "A2", "none", "60x60"})
    drawn({sample("shaft.obj"), "--projection", "front", "--dimensions", "overall", "--sheet", sheet});
}

TEST_F(DimensionsOfProgram, OfASceneFile) {
  const std::string scene = folder.file("scene.toml", "[[model]]\nfile = \"" + sample("bracket.obj") +
                                                          "\"\n"
                                                          "[[view]]\nprojection = \"front\"\n"
                                                          "[[dimension]]\ntype = \"overall\"\n"
                                                          "[[dimension]]\ntype = \"linear\"\ndirection = \"vertical\"\n"
                                                          "from = {point = [0, 0, 0]}\nto = {point = [0, 0, 10]}\n");
  EXPECT_EQ(dimensions_in(drawn({scene}), "front"), "80 75 10 ");
}

// A cube of 31.75 mm is 1.25 in.
TEST_F(DimensionsOfProgram, InInchesAfterAsme) {
  const std::string cube = root() / "tests/golden/models/cube.obj";
  const Words arguments = {cube,      "--views", "front,top", "--transform",      "scale:3.175", "--dimensions",
                           "overall", "--title", "x",         "--dimension-unit", "in"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), arguments.begin(), arguments.end());
    return drawn(more);
  };
  const std::string svg = with({});
  EXPECT_EQ(dimensions_in(svg, "front"), "1.250 1.250 ");
  EXPECT_TRUE(contains(svg, "aria-label=\"Dimensions in inches\""));
  EXPECT_EQ(dimensions_in(with({"--decimal-sign", ","}), "front"), "1,250 1,250 ");
  EXPECT_EQ(dimensions_in(with({"--decimal-sign", "comma"}), "front"), "1,250 1,250 ");
  EXPECT_EQ(dimensions_in(with({"--decimal-sign", "Point"}), "front"), "1.250 1.250 ");
  EXPECT_EQ(dimensions_in(with({"--dimension-decimals", "2"}), "front"), "1.25 1.25 ");
}

TEST_F(DimensionsOfProgram, DecimalSignsAreThoseOfTheSheet) {
  const std::string scene =
      folder.file("scene.toml", "[[model]]\nfile = \"" + sample("bracket.obj") +
                                    "\"\n[sheet]\nscale = \"1:2.5\"\nframe = \"full\"\ndecimal_sign = "
                                    "\",\"\n[[view]]\nprojection = \"front\"\n"
                                    "[[dimension]]\ntype = \"linear\"\ndirection = \"vertical\"\n"
                                    "from = {point = [0, 0, 0]}\nto = {point = [0, 0, 10.25]}\n"
                                    "text = \"<> +0.1\"\n");
  const std::string svg = drawn({scene});
  EXPECT_EQ(dimensions_in(svg, "front"), "10,25 +0.1 ") << "given text is drawn as given";
  EXPECT_TRUE(contains(svg, "aria-label=\"1:2,5\"")) << "the scale in the title block";
}

TEST_F(DimensionsOfProgram, Refused) {
  const std::string pictorial =
      refused({sample("bracket.obj"), "--projection", "two-point", "--dimensions", "overall"});
  EXPECT_TRUE(contains(pictorial, "--dimensions: no view shows the size of the models in true length")) << pictorial;
  const std::string word = refused({sample("bracket.obj"), "--dimensions", "overal"});
  EXPECT_TRUE(contains(word, "did you mean 'overall'?")) << word;
  const std::string scene = folder.file("scene.toml", "[[model]]\nfile = \"" + sample("bracket.obj") +
                                                          "\"\n[[dimension]]\ntype = \"overall\"\nview = \"fornt\"\n");
  const std::string view = refused({scene, "--views", "front,top"});
  EXPECT_TRUE(contains(view, "scene.toml:5")) << view;
  EXPECT_TRUE(contains(view, "did you mean 'front'?")) << view;
  for (const char* far : {"1e9", "1e20", "1e50"}) {
    const std::string away =
        refused({folder.file("far.toml", "[[model]]\nfile = \"" + sample("bracket.obj") +
                                             "\"\n[[dimension]]\ntype = \"linear\"\ndirection = \"horizontal\"\n"
                                             "from = {point = [0, 0, 0]}\nto = {point = [" +
                                             far + ", 0, 0]}\n")});
    EXPECT_TRUE(contains(away, "far.toml:3")) << away;
    EXPECT_TRUE(contains(away, "m away on the sheet")) << away;
  }
}

// Along the axes, where both ends of the models have corners.
TEST_F(DimensionsOfProgram, AxonometricViewsHaveSizesAlongTheAxes) {
  const std::string box = folder.file("box.obj",
                                      "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 0 0 25\nv 60 0 25\nv 60 40 25\n"
                                      "v 0 40 25\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const char* view : {"isometric", "dimetric", "trimetric", "cavalier", "planometric"})
    EXPECT_EQ(dimensions_in(drawn({box, "--projection", view, "--dimensions", "overall"}), view), "60 40 25 ") << view;
}

TEST_F(DimensionsOfProgram, HaveDecimalsByTheSizeOfTheModel) {
  // A box of 1.375 x 0.5 x 0.25.
  const std::string box = folder.file("box.obj",
                                      "v 0 0 0\nv 1.375 0 0\nv 1.375 0.5 0\nv 0 0.5 0\nv 0 0 0.25\nv 1.375 0 0.25\n"
                                      "v 1.375 0.5 0.25\nv 0 0.5 0.25\n"
                                      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const Words words{box, "--projection", "front", "--dimensions", "overall"};
  EXPECT_EQ(dimensions_in(drawn(words), "front"), "1.375 0.25 ");
  Words fewer = words;
  fewer.insert(fewer.end(), {"--dimension-decimals", "1"});
  EXPECT_EQ(dimensions_in(drawn(fewer), "front"), "1.4 0.2 ");
  Words large = words;
  large.insert(large.end(), {"--transform", "scale:100.001"});
  EXPECT_EQ(dimensions_in(drawn(large), "front"), "137.5 25 ");
}

TEST_F(DimensionsOfProgram, BeyondThePaperAreReported) {
  const Outcome run = epura({"draw", sample("bracket.obj"), "--projection", "front", "--dimensions", "overall",
                             "--sheet", "A4", "--scale", "2.7", "-o", "x.svg"},
                            folder / "");
  EXPECT_TRUE(contains(run.err, "dimensions of the view 'front' extend beyond the sheet")) << run.err;
}

}  // namespace
}  // namespace epura::test::dimensions_test
