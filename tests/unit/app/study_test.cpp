// SPDX-License-Identifier: Apache-2.0
// `epura study` becomes another program, or says that there is none.
#include <gtest/gtest.h>

#include <csignal>

#include "errors.hpp"
#include "program.hpp"

namespace epura::test {
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
  const Outcome run = draw_within("0.1", {"--verify"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "isometric: hidden lines by the exact method; no span longer than ")) << run.err;
}

TEST(MaxError, IsRefusedWhereItCannotBeKept) {
  const auto refused = [](const Outcome& outcome, const char* reason) {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(contains(outcome.err, reason)) << outcome.err;
  };
  refused(draw_within("1e-7"), "cannot be guaranteed");
  refused(draw_within("0.1", {"--visibility", "none"}), "omit --visibility none");
  refused(draw_within("0"), "--max-error: is 0");
}

}  // namespace
}  // namespace epura::test
