// SPDX-License-Identifier: Apache-2.0
// Frames, logos and styles of one's own, and outlines for laser cutters, from the command line.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::forms_test {
namespace {

const std::string frames = std::string(EPURA_TEST_SAMPLES) + "/frames/";

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Templates, GiveTheSizeAndTheFields) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("flange.obj"), "--views", "front,top", "--template", frames + "frame.svg",
                             "--logo", frames + "logo.svg", "--title", "Flange", "--number", "DRW-1", "-o", "x.svg"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(has(svg, "width=\"420mm\" height=\"297mm\"")) << svg.substr(0, 500);
  EXPECT_TRUE(has(svg, "aria-label=\"Flange\""));
  EXPECT_TRUE(has(svg, "aria-label=\"DRW-1\""));
  EXPECT_TRUE(has(svg, "aria-label=\"A3\""));
  EXPECT_TRUE(has(svg, "inkscape:label=\"template\""));
  EXPECT_TRUE(has(svg, "inkscape:label=\"logo\""));
  EXPECT_FALSE(has(svg, "aria-label=\"Legal owner\""));
}

TEST(Templates, WhatDoesNotFitTogetherIsRefused) {
  const Folder folder;
  folder.file("clone.svg",
              "<svg width=\"297mm\" height=\"210mm\">\n<text id=\"title\" font-size=\"4\"/>\n<use href=\"#a\"/></svg>");
  const auto refusal = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"draw", sample("flange.obj")});
    options.insert(options.end(), {"-o", "x.svg"});
    const Outcome run = epura(options, folder / "");
    EXPECT_EQ(run.code, 2) << run.err;
    return run.err;
  };
  EXPECT_TRUE(has(refusal({"--template", "clone.svg"}), "clone.svg:3"));
  EXPECT_TRUE(has(refusal({"--template", "none.svg"}), "none.svg"));
  EXPECT_TRUE(has(refusal({"--template", frames + "frame.svg", "--sheet", "A4"}), "is for A3, not A4"));
  EXPECT_TRUE(has(refusal({"--template", frames + "frame.svg", "--frame", "none"}), "--frame"));
  EXPECT_TRUE(has(refusal({"--logo", frames + "logo.svg", "--frame", "none"}), "title block"));
  EXPECT_TRUE(has(refusal({"--logo", sample("flange.obj")}), "neither an SVG nor a PNG"));
}

// Of few pixels.
std::string png() {
  const Folder folder;
  EXPECT_EQ(epura({"draw", sample("bracket.obj"), "--sheet", "10x10", "--dpi", "30", "-o", "p.png"}, folder / "").code,
            0);
  return read_file(folder / "p.png");
}

TEST(Logos, OfPixelsAreInEveryPicture) {
  const Folder folder;
  folder.file("logo.png", png());
  const Outcome run = epura({"draw", sample("flange.obj"), "--views", "front,top", "--logo", "logo.png", "-o", "x.svg",
                             "-o", "x.pdf", "-o", "x.png", "-o", "x.dxf", "-o", "x.html", "-o", "x.eps"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(has(read_file(folder / "x.svg"), "data:image/png;base64,iVBOR"));
  EXPECT_TRUE(has(read_file(folder / "x.html"), "img-src data:"));
  EXPECT_TRUE(has(read_file(folder / "x.pdf"), "/Image"));
  // What a format cannot show is not missing in silence, nor said of those that can.
  EXPECT_TRUE(has(run.err, "x.dxf: the picture logo.png is missing")) << run.err;
  EXPECT_FALSE(has(run.err, "x.svg")) << run.err;
}

TEST(StyleFiles, ChangeWidthsAndColours) {
  const Folder folder;
  folder.file("s.toml", "[visible]\nwidth = 1.25\ncolour = \"#003366\"\n[hidden]\ndashes = \"continuous\"\n");
  const Outcome run =
      epura({"draw", sample("flange.obj"), "--projection", "front", "--style", "s.toml", "-o", "x.svg"}, folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  EXPECT_TRUE(has(svg, "stroke=\"#003366\" stroke-width=\"1.25\""));
  EXPECT_FALSE(has(svg, "stroke-dasharray=\""));
}

// What stands in the section ENTITIES: types, and closed ones among the polylines.
struct Contours {
  int closed = 0, others = 0;
};

Contours contours_in(const std::string& dxf) {
  Contours contours;
  const std::string entities = dxf.substr(dxf.find("\nENTITIES\n"));
  const std::vector<std::string_view> lines = split(entities, '\n');
  std::string_view type;
  for (std::size_t i = 2; i + 1 < lines.size() && lines[i + 1] != "ENDSEC"; i += 2) {
    if (lines[i] == "0") type = lines[i + 1];
    if (lines[i] == "0") contours.others += 1;
    if ((lines[i] == "70" && type == "LWPOLYLINE" && lines[i + 1] == "1") || (lines[i] == "0" && type == "CIRCLE")) {
      contours.closed += 1;
      contours.others -= 1;
    }
  }
  return contours;
}

// A plate has its outline and two bores; a flange eight holes, rim, neck, chamfer and bore.
TEST(Laser, EachContourIsOneClosedLoop) {
  const std::string plate = std::string(EPURA_TEST_GOLDEN) + "/models/plate-two-bores.obj";
  for (const std::string arcs : {"--arcs", "--decimals=4"})
    for (const auto& [model, loops] :
         std::vector<std::pair<std::string, int>>{{plate, 3}, {sample("flange.obj"), 12}}) {
      const Folder folder;
      const Outcome run = epura({"draw", model, "--projection", "top", "--hidden", "none", "--sheet", "none", "--scale",
                                 "1:1", arcs, "-o", "x.dxf"},
                                folder / "");
      ASSERT_EQ(run.code, 0) << run.err;
      const Contours contours = contours_in(read_file(folder / "x.dxf"));
      EXPECT_EQ(contours.closed, loops) << model << arcs;
      EXPECT_EQ(contours.others, 0) << model << arcs;
    }
}

TEST(Laser, SectionsHaveClosedLoopsOnly) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("flange.obj"), "--projection", "top", "--section", "0,0,12:0,0,1", "--hidden", "none",
             "--hatch", "none", "--sheet", "none", "--scale", "1:1", "--arcs", "-o", "x.dxf"},
            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const Contours contours = contours_in(read_file(folder / "x.dxf"));
  EXPECT_EQ(contours.closed, 10);
  EXPECT_EQ(contours.others, 0);
}

}  // namespace
}  // namespace epura::test::forms_test
