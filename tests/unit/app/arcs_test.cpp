// SPDX-License-Identifier: Apache-2.0
// What `epura draw` says and writes when curves and centre lines are wanted.
#include <gtest/gtest.h>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::arcs_test {
namespace {

TEST(DrawArcs, RimsOfAFlangeAreCircles) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("flange.obj"), "--projection", "top", "--hidden", "none", "--arcs", "-o",
                             "x.svg", "-o", "x.json"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  // Eight holes, rim, neck, chamfer and bore.
  EXPECT_NE(run.err.find("12 of circles, 0 of ellipses"), std::string::npos) << run.err;
  const std::string svg = read_file(folder / "x.svg"), json = read_file(folder / "x.json");
  EXPECT_EQ(std::count(svg.begin(), svg.end(), 'A'), 12);  // each goes on without a letter
  EXPECT_NE(json.find("\"curves\": ["), std::string::npos);
}

TEST(DrawArcs, AreEllipsesInAnIsometricView) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("cylinders.obj"), "--arcs=0.005", "-o", "x.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err.find(" 0 of ellipses"), std::string::npos) << run.err;
}

TEST(DrawArcs, LinesStayLinesWithoutThem) {
  const Folder folder;
  ASSERT_EQ(epura({"draw", sample("flange.obj"), "-o", "x.json", "-o", "x.svg"}, folder / "").code, 0);
  EXPECT_EQ(read_file(folder / "x.json").find("curves"), std::string::npos);
}

TEST(DrawArcs, ToleranceMustBeALength) {
  const Folder folder;
  for (const std::string text : {"x", "0", "-1", "nan", "2"}) {
    const Outcome run = epura({"draw", sample("flange.obj"), "--arcs=" + text, "-o", "x.svg"}, folder / "");
    EXPECT_EQ(run.code, 2) << text;
    EXPECT_NE(run.err.find("--arcs"), std::string::npos) << run.err;
  }
}

TEST(DrawCentreLines, AreALayerOfTheirView) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("flange.obj"), "--projection", "top", "--centre-lines", "-o", "x.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_NE(svg.find("-top-centre\" inkscape:groupmode"), std::string::npos);
  // The cross of the flange, marks of eight holes, and the pitch circle that they lie on.
  const std::size_t begin = svg.find("-top-centre\" inkscape:groupmode"), end = svg.find("</g>", begin);
  std::size_t lines = 0;
  for (std::size_t at = begin; (at = svg.find("<path", at)) < end; ++at) ++lines;
  EXPECT_EQ(lines, 2U + 8 + 1);
}

}  // namespace
}  // namespace epura::test::arcs_test
