// SPDX-License-Identifier: Apache-2.0
// Drawings that lack lines because time was over say so everywhere; the progress line tells how far a run is.
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "../output/json_reader.hpp"
#include "base/text.hpp"
#include "errors.hpp"
#include "long_model.hpp"
#include "program.hpp"
#include "reading.hpp"

namespace epura::test::time_limit_test {
namespace {

constexpr int partial = 5;  // exit code

TEST(TimeLimit, ALongOneChangesNoByte) {
  const Folder folder;
  for (const char* format : {"svg", "json"}) {
    const std::vector<std::string> arguments{"draw", sample("bracket.obj"), "-o", "-", "--format", format};
    std::vector<std::string> limited = arguments;
    limited.insert(limited.end(), {"--time-limit", "1000"});
    const Outcome run = epura(limited, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, epura(arguments, folder / "").out);
  }
}

TEST(TimeLimit, WithoutTimeNothingIsWritten) {
  const Folder folder;
  folder.file("x.svg", "old");
  const Outcome run =
      epura({"draw", sample("bracket.obj"), "--time-limit", "0", "-o", "x.svg", "-o", "x.json"}, folder / "");
  EXPECT_EQ(run.code, partial);
  EXPECT_TRUE(contains(run.err, "'reading'")) << run.err;
  EXPECT_TRUE(contains(run.err, "nothing was written")) << run.err;
  EXPECT_TRUE(contains(run.err, "hint: ")) << run.err;
  EXPECT_EQ(folder.names().size(), 1U);
  EXPECT_EQ(read_file(folder / "x.svg"), "old");
}

std::set<std::string> segments_of(const std::string& json) {
  std::set<std::string> lines;
  for (std::string_view line : split(json, '\n')) {
    if (!line.starts_with("    {\"from\"")) continue;
    lines.emplace(line.substr(0, line.find("}", line.find("\"t\""))));
  }
  return lines;
}

TEST(TimeLimit, WhatIsShownIsAPartOfTheWholeDrawing) {
  const Folder folder;
  const std::string model = folder.file("tangle.obj", tangle(1000));
  const std::vector<std::string> arguments{"draw",     model,           "-o", "-",        "--format", "json", "--edges",
                                           "boundary", "--join-within", "0",  "--hidden", "dashed"};
  const std::set<std::string> whole = segments_of(epura(arguments, folder / "").out);
  ASSERT_GT(whole.size(), 3000U);
  for (const char* seconds : {"0.01", "0.015", "0.02", "0.03", "0.05"}) {
    std::vector<std::string> limited = arguments;
    limited.insert(limited.end(), {"--time-limit", seconds});
    const Outcome run = epura(limited, folder / "");
    if (run.code == 0) break;
    ASSERT_EQ(run.code, partial) << run.err;
    if (run.out.empty()) continue;  // no time for any line
    const Json counts = JsonReader(run.out).read()["partial"];
    EXPECT_EQ(counts["edges"].number(), 3000);
    EXPECT_TRUE(contains(run.err, counts["undecided"].text + " of 3000 edges")) << run.err;
    EXPECT_TRUE(contains(run.err, "cut short '" + counts["stages"].items.at(0).text + "'")) << run.err;
    for (const std::string& segment : segments_of(run.out)) EXPECT_TRUE(whole.contains(segment)) << segment;
  }
}

// What a run has said when it is done, having waited for its model for as long as `wait` takes.
template <class Wait>
std::string said(const std::string& when, const Wait& wait) {
  Reading reading({"--progress", when});
  wait(reading);
  reading.give_model();
  const Outcome run = reading.run.wait();
  EXPECT_EQ(run.code, 0);
  return run.err;
}

TEST(ProgressLine, IsShownAndErased) {
  const std::string err = said("always", [](const Reading& reading) { reading.wait_for_line(); });
  EXPECT_TRUE(err.starts_with("\repura: reading")) << err;
  EXPECT_TRUE(err.ends_with(" \r")) << err;
}

TEST(ProgressLine, IsNotShownToFilesNorWhenUnwanted) {
  const auto half_a_second = [](const Reading&) { std::this_thread::sleep_for(std::chrono::milliseconds(450)); };
  EXPECT_EQ(said("auto", half_a_second), "");
  EXPECT_EQ(said("never", half_a_second), "");
}

TEST(ProgressLine, IsShownAtTimesThatAreKnown) {
  const Folder folder;
  const Outcome run = epura({"draw", sample("gear.stl"), "-o", "x.svg", "--progress", "sometimes"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--progress")) << run.err;
}

TEST(ProgressLine, ShortRunsShowNone) {
  // On a busy machine no run may be short: then there is nothing to see.
  const Folder folder;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome run = epura({"draw", sample("cylinders.obj"), "-o", "x.svg", "--progress", "always"}, folder / "");
    EXPECT_EQ(run.code, 0);
    if (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(300)) {
      EXPECT_EQ(run.err, "");
      return;
    }
  }
}

}  // namespace
}  // namespace epura::test::time_limit_test
