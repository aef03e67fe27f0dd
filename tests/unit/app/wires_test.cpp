// SPDX-License-Identifier: Apache-2.0
// Lines of files that bound no face, from the file to what is written and told.
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::wires_test {
namespace {

using Words = std::vector<std::string>;

// A plate of 4 x 2 at height 1, and below it a line along its middle that is twice as long.
const std::string plate = "v 0 0 1\nv 4 0 1\nv 4 2 1\nv 0 2 1\nf 1 2 3 4\n";

struct Wires : ::testing::Test {
  Folder folder;
  std::string model = folder.file("m.obj", plate + "v -2 1 0\nv 6 1 0\nl 5 6\n");

  Outcome draw(const Words& more) {
    Words arguments{"draw", "m.obj", "--projection", "top", "--scale", "10:1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder / "");
  }
};

TEST_F(Wires, AreExplained) {
  const Outcome run = draw({"--why", "4-5"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out,
            "0:4-5 of m.obj, (-2, 1, 0) to (6, 1, 0)\n"
            "  drawn as wire: the file has a line here that bounds no face\n"
            "  visible t 0 to 0.25, (113.5, 105) to (133.5, 105) mm\n"
            "  hidden  t 0.25 to 0.75, (133.5, 105) to (173.5, 105) mm\n"
            "    by face 0:0 of m.obj, 1 in front, t 0.25 to 0.75\n"
            "  visible t 0.75 to 1, (173.5, 105) to (193.5, 105) mm\n");
  const Outcome unwanted = draw({"--edges", "contour,boundary", "--why", "4-5"});
  EXPECT_TRUE(contains(unwanted.out, "not drawn: wire edges are not selected; the file has a line here"))
      << unwanted.out;
}

TEST_F(Wires, AreALayerOfTheirOwnInAllFormats) {
  const Outcome run = draw({"--verify", "-o", "x.svg", "-o", "x.dxf", "-o", "x.json", "-o", "x.pdf"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(contains(svg, "inkscape:label=\"wire\""));
  EXPECT_TRUE(contains(svg, "data-kind=\"wire\" data-edge=\"4-5\""));
  EXPECT_TRUE(contains(read_file(folder / "x.dxf"), "top-wire"));
  EXPECT_TRUE(contains(read_file(folder / "x.json"), "\"kind\": \"wire\""));
  EXPECT_TRUE(contains(read_file(folder / "x.json"), "\"wires\": 1"));
  draw({"--edges", "contour,boundary", "-o", "without.svg"});
  EXPECT_FALSE(contains(read_file(folder / "without.svg"), "wire"));
  const Outcome compared = epura({"compare", "x.svg", "without.svg"}, folder / "");
  EXPECT_EQ(compared.code, 1);
  EXPECT_TRUE(contains(compared.out, "removed    top: wire line, 20 mm")) << compared.out;
}

TEST_F(Wires, AloneAreADrawing) {
  folder.file("m.obj", "v 0 0 0\nv 3 0 0\nv 3 4 0\nl 1 2 3\n");
  const Outcome run = draw({"--verify", "-o", "x.svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "data-kind=\"wire\" data-edge=\"0-1 1-2\""))
      << read_file(folder / "x.svg");
  const std::string info = epura({"info", "m.obj"}, folder / "").out;
  EXPECT_TRUE(contains(info, "0 triangles, 2 pieces of lines")) << info;
  EXPECT_TRUE(contains(info, "3 x 4 x 0, from (0, 0, 0) to (3, 4, 0)")) << info;
  EXPECT_TRUE(contains(info, "bodies    none")) << info;
  folder.file("m.obj", "v 0 0 0\nv 0 0 4\nl 1 2\n");
  const Outcome end_on = draw({"-o", "y.svg"});
  EXPECT_EQ(end_on.code, 0);
  EXPECT_TRUE(contains(end_on.err, "nothing is drawn: every line is seen end-on")) << end_on.err;
}

// What is beside the faces, such as annotations of STEP files, is not a size of the part.
TEST_F(Wires, DoNotWidenWhatIsMeasured) {
  EXPECT_EQ(draw({"--dimensions", "overall", "-o", "x.svg", "--svg-text", "text"}).code, 0);
  const std::string with_wires = read_file(folder / "x.svg");
  EXPECT_FALSE(contains(with_wires, ">8<"));
  folder.file("m.obj", plate);
  EXPECT_EQ(draw({"--dimensions", "overall", "-o", "y.svg", "--svg-text", "text"}).code, 0);
  EXPECT_TRUE(contains(with_wires, ">4<"));
  EXPECT_TRUE(contains(read_file(folder / "y.svg"), ">4<"));
}

}  // namespace
}  // namespace epura::test::wires_test
