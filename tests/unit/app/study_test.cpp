// SPDX-License-Identifier: Apache-2.0
// `epura study` becomes another program, or says that there is none.
#include <gtest/gtest.h>

#include <csignal>

#include "at_length.hpp"
#include "errors.hpp"
#include "program.hpp"

namespace epura::test::study_test {
namespace {

TEST(StudyProgram, IsNamedWhereItIsNotInstalled) {
  const Folder folder;
  // A copy of epura alone.
  const Outcome run = epura({"study", "stability"}, folder / "", {}, R"(cp "$0" epura && exec ./epura "$@")");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "/epura-study")) << run.err;
  EXPECT_TRUE(contains(run.err, "hint: install the package epura-study")) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(StudyProgram, GetsTheArgumentsAsTheyAre) {
  const Folder folder;
  const Outcome run = epura({"study", "stability", "--cases", "P1 P2", "-o", "-"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--format")) << run.err;
  const Outcome wrong = epura({"study", "stability", "--cases", "P1 P2"}, folder / "");
  EXPECT_TRUE(contains(wrong.err, "'P1 P2'")) << wrong.err;
}

TEST(StudyProgram, GetsTheSignals) {
  const Folder folder;
  Running run({"study", "stability", "--size", "100"}, folder / "");
  run.signal(SIGINT);
  EXPECT_EQ(run.wait().code, 128 + SIGINT);
}

TEST(StudyProgram, HasMethodsThatDrawingsDoNotTake) {
  const Folder folder;
  for (const char* method : {"sampled", "float", "item-buffer:dpi=600", "exact:bits=24"}) {
    const Outcome run = epura({"draw", sample("elbow.obj"), "--visibility", method, "-o", "x.svg"}, folder / "");
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, "'epura study accuracy' measures other methods")) << run.err;
  }
  const Outcome run = epura({"draw", sample("elbow.obj"), "--visibility", "noone", "-o", "x.svg"}, folder / "");
  EXPECT_TRUE(contains(run.err, "did you mean 'none'?")) << run.err;
  EXPECT_TRUE(folder.names().empty());
}

Outcome draw_within(const char* allowed, std::vector<std::string> more = {}) {
  const Folder folder;
  more.insert(more.begin(), {"draw", sample("elbow.obj"), "--max-error", allowed, "-o", "x.svg"});
  return epura(more, folder / "");
}

TEST(MaxError, IsKeptAndTold) {
  const Outcome run = draw_within("3", {"--verify"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err,
                       "max-error 3 mm: lines merged within 0.391 "
                       "mm, 1 decimals in SVG; hidden lines by the exact method"))
      << run.err;
  EXPECT_TRUE(contains(run.err, "isometric: lines are within ")) << run.err;
}

TEST(MaxError, IsRefusedWhereItCannotBeKept) {
  const auto refused = [](const Outcome& outcome, const char* reason) {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome.err, reason)) << outcome.err;
  };
  refused(draw_within("0.1"), "lines of view 'isometric' may be off by ");
  refused(draw_within("0.1"), " mm, or export the model with finer facets, or draw it from STEP");
  refused(draw_within("1.9", {"--join-within", "1"}), "may be off by ");
  refused(draw_within("0.1", {"--visibility", "none"}), "omit --visibility none");
  refused(draw_within("0"), "--max-error: is 0");
}

// Its fillets are tangent to their faces, so facets say nothing of where these meet; and at 0.2 mm, some contours end
// as those of facets do.
TEST(MaxError, IsKeptWhereFacesAreTangent) {
  const Folder folder;
  for (const char* allowed : {"0.01", "0.05", "0.2", "0.5", "2"}) {
    const Outcome run = epura({"draw", EPURA_TEST_SAMPLES "/step/clamp.step", "--views", "front,top,left", "--sheet",
                               "A3", "--scale", "2:1", "--max-error", allowed, "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
  }
}

TEST(MaxError, IsRefusedAtOnceWhereNothingIsCertain) {
  const Folder folder;
  const std::vector<std::string> draw{
      "draw", EPURA_TEST_SAMPLES "/step/clamp.step", "--max-error", "0.00001", "--time-limit", "20", "-o", "x.svg"};
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--sheet", "A3", "--scale", "2:1"}}) {
    std::vector<std::string> arguments = draw;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, "no part of a line shorter than a millionth of the drawing is certain")) << run.err;
    EXPECT_FALSE(contains(run.err, "hint: raise --max-error to ")) << run.err;  // a number that might take hours
  }
}

// What a refusal tells to ask for is kept, whatever was asked for before. Of facets that are made for it, see
// spline_faces_test.
TEST(MaxError, IsKeptAtTheValueOfTheHint) {
  const Folder folder;
  std::vector<std::string> models{sample("elbow.obj"), sample("shaft.obj"), sample("flange.obj")};
  if (at_length()) models.emplace_back(EPURA_TEST_SAMPLES "/step/clamp.step");  // a minute
  for (const std::string& model : models)
    for (const char* asked : {"0.001", "0.01"}) {
      const auto draw = [&](const std::string& allowed) {
        return epura({"draw", model, "--views", "front,isometric", "--max-error", allowed, "-o", "x.svg"}, folder / "");
      };
      const Outcome refused = draw(asked);
      if (refused.code == 0) continue;
      const std::string before = "hint: raise --max-error to ";
      const std::size_t from = refused.err.find(before), to = refused.err.find(" mm, or ", from);
      ASSERT_LT(from, to) << model << asked << refused.err;
      const Outcome kept = draw(refused.err.substr(from + before.size(), to - from - before.size()));
      EXPECT_EQ(kept.code, 0) << model << asked << refused.err << kept.err;
    }
}

// The coarsest decimals that keep to their share are chosen.
TEST(MaxError, ChoosesMergingAndDecimals) {
  const Folder folder;
  const auto svg = [&](const char* allowed) {
    const Outcome run =
        epura({"draw", sample("bracket.obj"), "--max-error", allowed, "-o", "-", "--format", "svg"}, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run;
  };
  EXPECT_TRUE(contains(svg("1").err, ", 2 decimals in SVG"));
  EXPECT_TRUE(contains(svg("0.3").err, ", 2 decimals in SVG"));
  EXPECT_TRUE(contains(svg("0.3").err, "lines merged within 0.06 mm"));
}

TEST(ErrorBudget, IsExplainedByTerms) {
  const Folder folder;
  const Outcome run = epura({"explain", sample("elbow.obj"), "--views", "front,top"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "error on paper, mm")) << run.out;
  for (const char* term : {"total", "surface", "contours", "file", "grid", "hiding"})
    EXPECT_TRUE(contains(run.out, std::string("\n") + term)) << term << run.out;
}

TEST(ErrorBudget, StandsAboveTheTitleBlock) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("flange.obj"), "--frame", "full", "--error-note", "--svg-text", "text",
                             "--language", "de", "-o", "-", "--format", "svg"},
                            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "Linien auf Papier auf 0.")) << run.out.substr(0, 2000);
}

}  // namespace
}  // namespace epura::test::study_test
