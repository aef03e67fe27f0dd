// SPDX-License-Identifier: Apache-2.0
// `epura draw --verify`: what it says, where, and with which exit code.
#include <gtest/gtest.h>

#include <algorithm>

#include "../output/json_reader.hpp"
#include "app/draw_files.hpp"
#include "base/file.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "words.hpp"

namespace epura::test::verify_test {
namespace {

TEST(Verify, ARightDrawingIsToldOnStandardError) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("bracket.obj"), "--verify", "-o", "-", "--format", "svg"}, folder / "");
  const Outcome plain = epura({"draw", sample("bracket.obj"), "-o", "-", "--format", "svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, plain.out);
  EXPECT_TRUE(contains(run.err, " decided, 0 wrong, ")) << run.err;
  EXPECT_TRUE(contains(run.err, "95 % confidence")) << run.err;
}

// Of all layouts tried, only the sheet that is kept is tested, and is the one that is drawn without a test.
TEST(Verify, TestsEachViewOfTheSheetOnce) {
  const Folder folder;
  const auto drawn = [&](std::vector<std::string> options) {
    for (const char* option : {"--views", "front,top,left,isometric", "--dimensions", "auto"})
      options.emplace_back(option);
    return draw_files(draw_options_of(options), pipeline::silent_messages(), {});
  };
  const std::string tested = (folder / "tested.svg").string(), plain = (folder / "plain.svg").string();
  const DrawnFiles with = drawn({sample("stairs.obj"), "--verify", "-o", tested});
  const DrawnFiles without = drawn({sample("stairs.obj"), "-o", plain});
  const auto laps = [](const DrawnFiles& files, const std::string& stage) {
    return std::ranges::count_if(files.watch.laps(), [&](const auto& lap) { return lap.first == stage; });
  };
  EXPECT_GT(laps(without, "drawing"), 4);
  EXPECT_EQ(laps(with, "verify"), 4);
  ASSERT_TRUE(with.report.verification.has_value());
  EXPECT_EQ(with.report.verification->wrong, 0);
  EXPECT_EQ(read_file(tested), read_file(plain));
}

TEST(Verify, TheReportHoldsIt) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("cylinders.obj"), "--projection", "look-at:eye=400,-900,500", "--verify",
                             "--verify-samples", "300", "-o", "-", "--format", "json"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = JsonReader(run.out).read();
  const Json& found = json["report"]["verify"];
  EXPECT_EQ(
      found.keys(),
      "points decided either_way wrong samples length misclassified at_most undecided untested strata worst outline "
      "ink");
  const Json& outline = found["outline"];
  EXPECT_EQ(outline.keys(), "lines asked missing ink unfounded doubled undecided length at_most worst");
  EXPECT_GT(outline["asked"].number(), 150);
  EXPECT_GT(outline["ink"].number(), 150);
  EXPECT_LT(outline["at_most"].number(), 0.02);
  EXPECT_TRUE(outline["worst"].items.empty());
  const Json& ink = found["ink"];
  EXPECT_EQ(ink.keys(), "error length judged by_surfaces unjudged unfounded missing faults worst");
  EXPECT_GT(ink["length"].number(), 1000);
  EXPECT_EQ(ink["judged"].number(), ink["length"].number());
  EXPECT_EQ(ink["by_surfaces"].number(), ink["length"].number());
  EXPECT_EQ(ink["faults"].number(), 0);
  EXPECT_GE(found["samples"].number(), 300);
  EXPECT_GT(found["points"].number(), found["samples"].number());
  EXPECT_EQ(found["wrong"].number(), 0);
  EXPECT_TRUE(found["worst"].items.empty());
  double samples = 0;
  for (const Json& stratum : found["strata"].items) samples += stratum["samples"].number();
  EXPECT_EQ(samples, found["samples"].number());
}

TEST(Verify, HiddenLinesThatAreNotWantedAreNotMissed) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("bracket.obj"), "--hidden", "none", "--verify", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(Verify, AWireframeIsRefused) {
  const Folder folder;
  const Outcome run =
      epura({"draw", sample("bracket.obj"), "--visibility", "none", "--verify", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--verify")) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(Verify, AWrongDrawingEndsWithOne) {
  DrawnFiles drawn;
  EXPECT_EQ(exit_code_of(drawn), 0);
  report::Verification& found = drawn.report.verification.emplace();
  EXPECT_EQ(exit_code_of(drawn), 0);
  drawn.report.partial.add_stage("drawing");
  EXPECT_EQ(exit_code_of(drawn), 5);
  found.outline.missing = 1;
  EXPECT_EQ(exit_code_of(drawn), 1);
  found.outline = {};
  found.wrong = 1;
  EXPECT_EQ(exit_code_of(drawn), 1);
}

// A prism in two storeys, cut open at the top: walls seen edge-on hide all that is drawn, so no point has an answer.
TEST(Verify, APassNeedsPointsThatAreDecided) {
  const Folder folder;
  const std::string walls =
      folder.file("walls.obj",
                  "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 5\nv 9 0 5\nv 0 9 5\nv 0 0 10\nv 9 0 10\nv 0 9 10\n"
                  "f 3 2 1\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\nf 4 5 8 7\nf 5 6 9 8\nf 6 4 7 9\nf 7 8 9\n");
  const auto verify = [&](const char* near) {
    return epura({"draw", walls, "--projection", "top", near, "--verify", "-o", "x.svg"}, folder / "");
  };
  const Outcome whole = verify("--near=-30");
  EXPECT_EQ(whole.code, 0) << whole.err;
  const Outcome cut = verify("--near=-2");
  EXPECT_EQ(cut.code, 1) << cut.err;
  EXPECT_TRUE(contains(cut.err, "inconclusive: only 0 of ")) << cut.err;
  EXPECT_TRUE(contains(cut.err, "turn the view a little")) << cut.err;
}

class VerifySample : public testing::TestWithParam<const char*> {};

TEST_P(VerifySample, HasItsOutline) {
  const Folder folder;
  for (const char* model : {"bearing.obj", "bracket.obj", "cylinders.obj", "elbow.obj", "flange.obj", "gear.stl",
                            "house.obj", "shaft.obj", "sombrero.obj", "stairs.obj"}) {
    const Outcome run =
        epura({"draw", sample(model), "--projection", GetParam(), "--verify", "-o", "x.svg"}, folder / "");
    EXPECT_TRUE(contains(run.err, " places that need ink, 0 (0 mm) without it")) << model << run.err;
    EXPECT_TRUE(contains(run.err, " places with ink, 0 (0 mm) unfounded, 0 (0 mm) doubled")) << model << run.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Views, VerifySample, testing::Values("isometric", "top", "two-point", "cabinet"));

}  // namespace
}  // namespace epura::test::verify_test
