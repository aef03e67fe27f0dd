// SPDX-License-Identifier: Apache-2.0
// Styles of bodies by their names, from the scene file to what is written and told.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::styles_test {
namespace {

// Two plates of 2 x 2, the lower one at height 0.
const std::string points = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1\n";
const std::string lower = "o lower plate\nf 1 2 3 4\n", upper = "o upper plate\nf 5 6 7 8\n";

struct Styles : ::testing::Test {
  Folder folder;

  // Both plates from above, with lines of styles.
  Outcome draw(const std::string& styles, const std::string& file) {
    folder.file("m.obj", points + lower + upper);
    folder.file("s.toml", "[[model]]\nfile = \"m.obj\"\n" + styles + "[[view]]\nprojection = \"isometric\"\n");
    return epura({"draw", "s.toml", "-o", file, "--scale", "10:1"}, folder / "");
  }
};

TEST_F(Styles, OmitBodies) {
  EXPECT_EQ(draw("[[style]]\nmatch = \"low*\"\ndrawn = false\n", "without.json").code, 0);
  folder.file("one.obj", points + upper);
  ASSERT_EQ(epura({"draw", "one.obj", "-o", "one.json", "--scale", "10:1"}, folder / "").code, 0);
  const Outcome same = epura({"compare", "one.json", "without.json"}, folder / "");
  EXPECT_EQ(same.code, 0) << same.out;
  const Json drawing = JsonReader(read_file(folder / "without.json")).read();
  for (const Json& segment : drawing["views"].items[0]["segments"].items) {
    EXPECT_EQ(segment["body"].number(), 1);
    EXPECT_GE(segment["edge"].items[0].number(), 4);
  }
}

TEST_F(Styles, ColourLayers) {
  const Outcome run = draw(
      "[[style]]\nmatch = \"*\"\ncolour = \"#0000ff\"\n[[style]]\nmatch = \"upper ?late\"\n"
      "colour = \"#C00\"\nline = \"narrow\"\n",
      "x.svg");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, "inkscape:label=\"visible #0000ff\"")) << svg;
  EXPECT_TRUE(contains(svg, "inkscape:label=\"narrow #cc0000\"")) << svg;
  EXPECT_TRUE(contains(svg, "stroke=\"#cc0000\" stroke-width=\".25\"")) << svg;
  draw("[[style]]\nmatch = \"*\"\ncolour = \"#ff0000\"\n", "x.dxf");
  EXPECT_TRUE(contains(read_file(folder / "x.dxf"), "isometric-visible #ff0000\n70\n0\n62\n10\n"));
}

TEST_F(Styles, ThatMatchNothingAreReported) {
  EXPECT_TRUE(contains(draw("[[style]]\nmatch = \"lid\"\nline = \"narrow\"\n", "x.svg").err,
                       "s.toml:4:9: no body or model is called 'lid'"));
  // The name of the model is that of all its bodies.
  EXPECT_EQ(draw("[[style]]\nmatch = \"m\"\nline = \"narrow\"\n", "x.svg").err, "");
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "inkscape:label=\"narrow\""));
  const Outcome wrong = draw("[[style]]\nmatch = \"m\"\ncolour = \"red\"\n", "x.svg");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(contains(wrong.err, "s.toml:5:10: 'colour' 'red' is not a colour")) << wrong.err;
  EXPECT_TRUE(contains(wrong.err, "#rgb or #rrggbb, such as #c00, or file")) << wrong.err;
}

TEST_F(Styles, MatchTheOnlyBodyOfAFile) {
  folder.file("m.obj", points + upper);
  folder.file("s.toml",
              "[[model]]\nfile = \"m.obj\"\n[[style]]\nmatch = \"upper*\"\nline = \"narrow\"\n"
              "[[view]]\nprojection = \"isometric\"\n");
  EXPECT_EQ(epura({"draw", "s.toml", "-o", "x.svg"}, folder / "").err, "");
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "inkscape:label=\"narrow\""));
}

TEST_F(Styles, LayersOfBodiesHaveTheirNames) {
  folder.file("m.obj", points + lower + upper);
  ASSERT_EQ(epura({"draw", "m.obj", "--layers", "body", "-o", "x.svg", "-o", "x.dxf"}, folder / "").code, 0);
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, "inkscape:label=\"visible lower plate\"")) << svg;
  EXPECT_TRUE(contains(svg, "inkscape:label=\"visible upper plate\"")) << svg;
  EXPECT_TRUE(contains(read_file(folder / "x.dxf"), "isometric-visible lower plate\n"));
  folder.file("m.obj", points + upper);
  ASSERT_EQ(epura({"draw", "m.obj", "--layers", "body", "-o", "x.svg"}, folder / "").code, 0);
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "inkscape:label=\"visible upper plate\""));
}

TEST_F(Styles, LeaveBodiesWhole) {
  const std::string box = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  folder.file("box.obj", points + box);
  const std::string scene =
      "[[model]]\nfile = \"box.obj\"\n[[model]]\nfile = \"box.obj\"\nname = \"bolt\"\n"
      "transform = \"translate:AT,0.1,0.1\"\n[[style]]\nmatch = \"bolt\"\ncut = false\n"
      "[[section]]\nname = \"A\"\npoint = [1, 1, 0]\nnormal = [-1, 0, 0]\n"
      "[[view]]\nprojection = \"top\"\nsection = \"A\"\n";
  const auto vertices_of_bolt = [&](const std::string& at) {
    std::string text = scene;
    text.replace(text.find("AT"), 2, at);
    folder.file("s.toml", text);
    EXPECT_EQ(epura({"draw", "s.toml", "-o", "x.json", "--hidden", "none"}, folder / "").code, 0);
    const Json drawing = JsonReader(read_file(folder / "x.json")).read();
    double length = 0;
    for (const Json& segment : drawing["views"].items[0]["segments"].items) {
      EXPECT_NE(segment["model"].number() + (segment["kind"].text == "section" ? 1 : 0), 2) << "the bolt is cut";
      if (segment["model"].number() == 1) length += segment["t"].items[1].number() - segment["t"].items[0].number();
    }
    return length;
  };
  EXPECT_NEAR(vertices_of_bolt("0.5"), 4, 1e-9) << "on both sides of the plane: whole";
  EXPECT_NEAR(vertices_of_bolt("-4"), 0, 1e-9) << "in front of it: removed";
  EXPECT_NEAR(vertices_of_bolt("4"), 4, 1e-9) << "behind it";
}

}  // namespace
}  // namespace epura::test::styles_test
