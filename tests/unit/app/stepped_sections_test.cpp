// SPDX-License-Identifier: Apache-2.0
// Offset and half sections and the hatching of bodies, from the scene file to what is drawn.
#include <gtest/gtest.h>

#include <cmath>

#include "../output/json_reader.hpp"
#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::stepped_sections_test {
namespace {

const std::string box_file =
    "v 0 0 0\nv 8 0 0\nv 8 4 0\nv 0 4 0\nv 0 0 2\nv 8 0 2\nv 8 4 2\nv 0 4 2\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

struct SteppedSections : ::testing::Test {
  Folder folder;

  // A box of 8 x 4 x 2 from the front, or in another view; `section` has the keys of the section.
  Outcome draw(const std::string& section, const std::string& file, const std::string& projection = "front",
               const std::vector<std::string>& more = {}) {
    folder.file("box.obj", box_file);
    folder.file("s.toml", "[[model]]\nfile = \"box.obj\"\n[[section]]\nname = \"A\"\n" + section +
                              "\n[[view]]\nprojection = \"" + projection +
                              "\"\nsection = \"A\"\nhidden = \"none\"\n[[style]]\nmatch = \"box\"\n" + style);
    std::vector<std::string> arguments{"draw", "s.toml", "-o", file, "--scale", "10:1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder / "");
  }
  std::string style = "line = \"visible\"\n";
};

TEST_F(SteppedSections, StraightPathIsAPlane) {
  ASSERT_EQ(draw("point = [0, 1, 0]", "plane.json").code, 0);
  const Outcome run = draw("path = [[0, 1, 0], [3, 1, 0], [5, 1, 0]]", "path.json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(read_file(folder / "plane.json"), read_file(folder / "path.json"));
}

TEST_F(SteppedSections, HaveNoLineAtTheStep) {
  const std::string path = "path = [[0, 1, 0], [3, 1, 0], [3, 2, 0], [5, 2, 0]]";
  const Outcome run = draw(path, "step.json", "front", {"--verify"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, " 0 wrong")) << run.err;
  const Json drawing = JsonReader(read_file(folder / "step.json")).read();
  const Json& view = drawing["views"].items[0];
  double length = 0;
  for (const Json& segment : view["segments"].items) {
    const auto at = [&](const char* end, std::size_t i) { return segment[end].items[i].number(); };
    const double dx = at("to", 0) - at("from", 0), dy = at("to", 1) - at("from", 1);
    EXPECT_TRUE(dx == 0 || dy == 0);
    if (dx == 0) {
      length += std::abs(dy);
    }
  }
  EXPECT_NEAR(length, 2 * 20, 1e-9);  // the sides of the box only
  ASSERT_EQ(view["cut_faces"].items.size(), 1U);
  EXPECT_EQ(view["cut_faces"].items[0]["rings"].items.size(), 2U);
}

TEST_F(SteppedSections, AreSeenAlongTheirSteps) {
  const std::string path = "path = [[0, 1, 0], [3, 1, 0], [3, 2, 0], [5, 2, 0]]";
  const Outcome run = draw(path, "step.svg", "isometric");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "s.toml:8:11")) << run.err;
  EXPECT_TRUE(contains(run.err, "does not look along the steps of section A")) << run.err;
  EXPECT_EQ(draw("path = [[0, 1], [3, 1]]", "step.svg").code, 2);
}

TEST_F(SteppedSections, HalfSectionsHaveACentreLine) {
  ASSERT_EQ(draw("path = [[0, 2, 0], [4, 2, 0], [4, 0, 0]]", "half.svg").code, 0);
  EXPECT_TRUE(contains(read_file(folder / "half.svg"), "inkscape:label=\"centre\""));
}

TEST_F(SteppedSections, AreHatchedByStyle) {
  const std::string plane = "point = [0, 1, 0]";
  const auto count = [&](const std::string& of_style, const std::vector<std::string>& more = {}) {
    style = of_style;
    const Outcome run = draw(plane, "x.dxf", "front", more);
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string dxf = read_file(folder / "x.dxf");
    int lines = 0;
    for (std::size_t at = dxf.find("\nfront-hatch\n"); at != std::string::npos;
         at = dxf.find("\nfront-hatch\n", at + 1))
      ++lines;
    return lines;
  };
  const int none = count("hatch = \"none\"\n"), general = count("hatch = \"general\"\nhatch_pitch = 2\n");
  const int fine = count("hatch_pitch = 1\nhatch_angle = 60\n");
  EXPECT_LE(none, 1);  // the table of layers
  EXPECT_GT(general, 10);
  EXPECT_GT(fine, 1.5 * general);
  EXPECT_EQ(count("hatch = \"steel\"\n", {"--hatch", "none"}), none);
  style = "hatch_pitch = 0.1\n";
  EXPECT_TRUE(contains(draw(plane, "x.dxf").err, "hatch_pitch"));
}

}  // namespace
}  // namespace epura::test::stepped_sections_test
