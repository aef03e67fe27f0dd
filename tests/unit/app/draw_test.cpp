// SPDX-License-Identifier: Apache-2.0
// What `epura draw` gives when all is well.
#include <gtest/gtest.h>

#include <map>
#include <string_view>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::draw_test {
namespace {

using Names = std::vector<std::string>;

const std::map<std::string, std::string_view>& beginnings() {
  static const std::map<std::string, std::string_view> table{
      {"svg", "<?xml version=\"1.0\""}, {"pdf", "%PDF-1."},           {"ps", "%!PS-Adobe-3"},
      {"eps", "%!PS-Adobe-3.0 EPSF"},   {"png", "\x89PNG\r\n\x1A\n"}, {"json", "{\"epura\": 1,"},
      {"html", "<!DOCTYPE html><html"}, {"dxf", "999\nepura\n"}};
  return table;
}

TEST(Draw, EveryFormatByItsExtension) {
  const Folder folder;
  for (const auto& [format, beginning] : beginnings()) {
    const Outcome run = epura({"draw", sample("cylinders.obj"), "-o", "x." + format}, folder / "");
    EXPECT_EQ(run.code, 0) << format;
    EXPECT_EQ(run.out, "") << format;
    EXPECT_EQ(run.err, "") << format;
    EXPECT_EQ(read_file(folder / ("x." + format)).substr(0, beginning.size()), beginning);
  }
  EXPECT_EQ(folder.names(), (Names{"x.dxf", "x.eps", "x.html", "x.json", "x.pdf", "x.png", "x.ps", "x.svg"}));
}

// Its rims are turned against each other by half a facet: corners of one peep out beside the other.
TEST(Draw, PlottersDrawTheRimOfACylinderSeenAlongItsAxisOnce) {
  const Folder folder;
  const auto lines = [&](const char* within) {
    const std::string model = EPURA_TEST_GOLDEN "/models/twisted-cylinder.obj";
    EXPECT_EQ(epura({"draw", model, "--projection", "top", "--scale", "2:1", "--join-within", within, "-o", "x.dxf"},
                    folder / "")
                  .code,
              0);
    const std::string dxf = read_file(folder / "x.dxf");
    std::size_t count = 0;
    for (const std::string_view type : {"\nLWPOLYLINE\n", "\nLINE\n"})
      for (std::size_t at = dxf.find(type); at != std::string::npos; at = dxf.find(type, at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(lines("0.1"), 1U);
  EXPECT_GT(lines("0"), 2U);
}

TEST(Draw, ExtensionsMayBeCapitals) {
  const Folder folder;
  EXPECT_EQ(epura({"draw", sample("cylinders.obj"), "-o", "X.PDF"}, folder / "").code, 0);
  EXPECT_EQ(read_file(folder / "X.PDF").substr(0, 5), "%PDF-");
}

TEST(Draw, SeveralFilesInOneRunAreThoseOfSingleRuns) {
  const Folder folder;
  std::vector<std::string> arguments{"draw", sample("bracket.obj")};
  for (const auto& [format, beginning] : beginnings()) {
    arguments.insert(arguments.end(), {"-o", "all." + format});
    ASSERT_EQ(epura({"draw", sample("bracket.obj"), "-o", "one." + format}, folder / "").code, 0);
  }
  ASSERT_EQ(epura(arguments, folder / "").code, 0);
  for (const auto& [format, beginning] : beginnings())
    EXPECT_EQ(read_file(folder / ("all." + format)), read_file(folder / ("one." + format))) << format;
}

TEST(Draw, StandardOutputHoldsTheFileAndNothingElse) {
  const Folder folder;
  for (const auto& [format, beginning] : beginnings()) {
    const Outcome run =
        epura({"draw", sample("cylinders.obj"), "-o", "-", "--format", format, "-o", "x." + format}, folder / "");
    EXPECT_EQ(run.code, 0) << format;
    EXPECT_EQ(run.out, read_file(folder / ("x." + format))) << format;
  }
}

TEST(Draw, OptionsMayStandBeforeTheModels) {
  const Folder folder;
  const Outcome run = epura({"draw", "-o", "a.svg", "--transform", "scale:2", sample("cylinders.obj")}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.names(), Names{"a.svg"});
}

TEST(Draw, ManyModelsAreOneDrawing) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("cylinders.obj"), sample("bracket.obj"), "--transform",
                             "translate:-200,0,0", "--transform", "scale:0.5", "-o", "-", "--format", "json"},
                            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "\"model\": 0,"));
  EXPECT_TRUE(contains(run.out, "\"model\": 1,"));
}

TEST(Draw, TheSameBytesForAnyNumberOfThreads) {
  const Folder folder;
  for (const char* format : {"svg", "pdf", "json"})
    for (const char* projection : {"isometric", "two-point"}) {
      std::string first;
      for (const char* threads : {"1", "2", "3", "7", "0", "0"}) {
        const Outcome run = epura({"draw", sample("bracket.obj"), sample("gear.stl"), "--projection", projection,
                                   "--threads", threads, "-o", "-", "--format", format},
                                  folder / "");
        ASSERT_EQ(run.code, 0) << run.err;
        if (first.empty()) first = run.out;
        EXPECT_TRUE(run.out == first) << format << " " << projection << ", " << threads << " threads";
      }
    }
}

TEST(Draw, TimesAreToldOnlyWhenAskedFor) {
  const Folder folder;
  const Outcome plain = epura({"draw", sample("cylinders.obj"), "-o", "-", "--format", "json"}, folder / "");
  const Outcome timed =
      epura({"draw", sample("cylinders.obj"), "-o", "-", "--format", "json", "--timings"}, folder / "");
  EXPECT_FALSE(contains(plain.out, "\"time\""));
  EXPECT_TRUE(contains(timed.out, "\"time\""));
  for (const char* stage : {"read", "view", "edges", "visibility", "drawing", "sheet", "write"})
    EXPECT_TRUE(contains(timed.err, stage)) << timed.err;
}

TEST(Draw, AnEmptyDrawingIsSaid) {
  const Folder folder;
  const std::string cube = folder.file("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome run = epura({"draw", cube, "-o", "x.svg", "--edges", "crease"}, folder / "");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "nothing is drawn")) << run.err;
}

TEST(Draw, WhatWasRepairedIsSaid) {
  const Folder folder;
  const std::string model =
      folder.file("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 nan\nf 1 2 3\nf 1 1 2\nf 2 3 4\nf 3 1 2\n");
  const Outcome run = epura({"draw", model, "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0);
  for (const char* said :
       {"1 face left out: fewer than three distinct corners", "1 face left out: the corners of an earlier face",
        "1 face left out: coordinates that are not finite"})
    EXPECT_TRUE(contains(run.err, said)) << run.err;
  EXPECT_TRUE(contains(run.err, model)) << run.err;
}

// Exporters of CAD leave some in every file.
TEST(Draw, AFewFacesThatCollapseAreNoMatterForAWarning) {
  const Folder folder;
  std::string model;
  for (int i = 0; i < 12; ++i)
    model += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + " 0 1\nv " + std::to_string(i) + ".5 0 0\n";
  for (int i = 0; i < 12; ++i)
    model +=
        "f " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " " + std::to_string(3 * i + 3) + "\n";
  const auto said = [&](const std::string& faces) {
    const Outcome run =
        epura({"draw", folder.file("m.obj", model + faces), "-o", "x.svg", "-o", "x.json"}, folder / "");
    EXPECT_EQ(run.code, 0);
    return run.err;
  };
  EXPECT_EQ(said("f 1 1 2\n"), "");
  EXPECT_TRUE(contains(read_file(folder / "x.json"), "\"dropped_degenerate\": 1"));
  EXPECT_TRUE(contains(said("f 1 1 2\nf 2 1 2\n"), "2 faces left out: fewer than three distinct corners"));
}

TEST(Draw, ADrawingLargerThanTheSheetIsSaid) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("bracket.obj"), "-o", "x.svg", "--scale", "20:1"}, folder / "");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.err, "the drawing is larger than the sheet at 20:1; it fits at 1:1")) << run.err;
  EXPECT_FALSE(read_file(folder / "x.svg").empty());
}

constexpr const char* plate_of_160_by_100 =
    "v 0 0 0\nv 160 0 0\nv 0 100 0\nv 160 100 0\nv 0 0 20\nv 160 0 20\nv 0 100 20\nv 160 100 20\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

// The views of 1:1 are 10 mm from the frame, where the centring marks end.
TEST(Draw, ASheetThatIsFullIsSaid) {
  const Folder folder;
  const std::string plate = folder.file("plate.obj", plate_of_160_by_100);
  const auto said = [&](const char* scale) {
    const Outcome run =
        epura({"draw", plate, "--views", "front,top", "--sheet", "A4", "--portrait", "--scale", scale, "-o", "x.svg"},
              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  };
  EXPECT_EQ(said("1:1"), "epura: the views fill the sheet at 1:1; 1:2 leaves room around them\n");
  EXPECT_EQ(said("1:2"), "");
}

TEST(Draw, GivenPositionsWithoutRoomAreSaid) {
  const Folder folder;
  folder.file("plate.obj", plate_of_160_by_100);
  const Outcome run = epura({"draw", folder.file("s.toml", R"([[model]]
file = "plate.obj"
[[view]]
projection = "front"
at = [150, 100]
[[view]]
projection = "top"
at = [150, 100]
[sheet]
size = "A3"
scale = "1:1"
)"),
                             "-o", "x.svg"},
                            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "views may be on one another")) << run.err;
  EXPECT_FALSE(contains(run.err, "larger than the sheet")) << run.err;
}

TEST(Draw, WhatTheFontCannotWriteIsSaid) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("bracket.obj"), "-o", "x.svg", "--frame", "full", "--title",
                             "\xF4\x8F\xBF\xBD \xF4\x8F\xBF\xBC x"},
                            folder / "");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "no installed font has '\xF4\x8F\xBF\xBD' '\xF4\x8F\xBF\xBC' (in the title)"))
      << run.err;
}

TEST(Draw, WhatTheFontLacksComesFromOtherFonts) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("bracket.obj"), "-o", "x.pdf", "-o", "x.svg", "-o", "x.png", "--frame",
                             "full", "--title", "☃ x אב", "--owner", "☂"},
                            folder / "");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "characters that the lettering font lacks are drawn in other fonts: '")) << run.err;
  for (const char* letter : {"☃", "☂", "א", "ב"}) EXPECT_TRUE(contains(run.err, letter)) << run.err;
  EXPECT_FALSE(contains(run.err, "no installed font")) << run.err;
}

TEST(Draw, LetteringOfSvgIsOutlinesOrText) {
  const Folder folder;
  const auto draw = [&](const std::string& how) {
    return epura({"draw", sample("bracket.obj"), "-o", "-", "--format", "svg", "--frame", "full", "--title", "Bracket",
                  "--svg-text", how},
                 folder / "");
  };
  EXPECT_TRUE(contains(draw("outlines").out, "aria-label=\"Bracket\""));
  EXPECT_TRUE(contains(draw("text").out, ">Bracket</text>"));
  const Outcome refused = draw("glyphs");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(contains(refused.err, "--svg-text")) << refused.err;
}

TEST(Draw, IdsOfSvgBeginAsAskedFor) {
  const Folder folder;
  const auto draw = [&](const std::string& prefix) {
    return epura({"draw", sample("bracket.obj"), "-o", "-", "--format", "svg", "--id-prefix", prefix}, folder / "");
  };
  const std::string svg = draw("left").out;
  EXPECT_TRUE(contains(svg, "<svg id=\"left\"") && contains(svg, "<g id=\"left-isometric-visible\"") &&
              contains(svg, "<path id=\"left-0\""));
  const Outcome refused = draw("1st");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(contains(refused.err, "--id-prefix: '1st' cannot begin an id")) << refused.err;
}

TEST(Draw, HugeCoordinatesAreDrawnUpToTheBorder) {
  const Folder folder;
  const std::string small = folder.file("small.obj", "v -1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nf 1 2 3\nf 1 2 4\n");
  const std::string huge =
      folder.file("huge.obj", "v -1e50 0 0\nv 1e50 0 0\nv 0 1e50 0\nv 0 0 -1e50\nf 1 2 3\nf 1 2 4\n");
  const auto lines = [&](const std::string& model) {
    const Outcome run = epura({"draw", model, "-o", "-", "--format", "svg", "--plain"}, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  // They look alike: fitted to the sheet, at most the last digit differs.
  EXPECT_EQ(lines(small).size(), lines(huge).size());
  const std::string beyond = folder.file("beyond.obj", "v -1 0 0\nv 1 0 0\nv 0 1e155 0\nf 1 2 3\n");
  const Outcome refused = epura({"draw", beyond, "-o", "x.svg"}, folder / "");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(contains(refused.err, beyond + ": has a vertex at 1e+155")) << refused.err;
}

TEST(Draw, AnOldFileIsReplacedAndKeepsItsMode) {
  const Folder folder;
  const std::string old = folder.file("x.svg", "old");
  std::filesystem::permissions(old, std::filesystem::perms(0640));
  ASSERT_EQ(epura({"draw", sample("cylinders.obj"), "-o", "x.svg"}, folder / "").code, 0);
  EXPECT_EQ(static_cast<int>(std::filesystem::status(old).permissions()), 0640);
  EXPECT_NE(read_file(old), "old");
  EXPECT_EQ(folder.names(), Names{"x.svg"});
}

}  // namespace
}  // namespace epura::test::draw_test
