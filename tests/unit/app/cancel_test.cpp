// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and its like: the run ends at once, and everything is as if it had never begun.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "errors.hpp"
#include "long_model.hpp"
#include "program.hpp"
#include "reading.hpp"

namespace epura::test::cancel_test {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using Names = std::vector<std::string>;

constexpr double max_seconds = 2;  // for busy machines; alone it takes a tenth of that

void expect_ended(Running& run, int signal) {
  const auto start = Clock::now();
  run.signal(signal);
  const Outcome outcome = run.wait();
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), max_seconds);
  EXPECT_EQ(outcome.code, 128 + signal);
  EXPECT_EQ(outcome.err, "epura: cancelled\n");
}

class AtAnyTime : public testing::TestWithParam<int> {};

TEST_P(AtAnyTime, TheRunEndsAndTheOldFileStays) {
  Reading reading({"-o", "new.pdf", "--hidden", "dashed"});
  reading.folder.file("x.svg", "old");
  reading.give_model(tangle(1500));
  std::this_thread::sleep_for(milliseconds(GetParam()));
  expect_ended(reading.run, SIGINT);
  EXPECT_EQ(read_file(reading.folder / "x.svg"), "old");
  EXPECT_EQ(reading.folder.names(), (Names{"model.obj", "x.svg"}));
}

INSTANTIATE_TEST_SUITE_P(Cancel, AtAnyTime, testing::Values(10, 100, 300, 600),
                         [](const auto& of) { return std::to_string(of.param) + "ms"; });

TEST(Cancel, EndsARunThatWaitsForItsModel) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Reading reading;
    expect_ended(reading.run, signal);
    EXPECT_EQ(reading.folder.names(), Names{"model.obj"});
  }
}

TEST(Cancel, EndsARunThatWaitsForTheReaderOfItsDrawing) {
  const Folder folder;
  const std::string drawing = pipe_in(folder, "x.svg");
  Running run({"draw", sample("cylinders.obj"), "-o", "x.svg"}, folder / "");
  std::this_thread::sleep_for(milliseconds(300));
  expect_ended(run, SIGINT);
}

// As under nohup, or in the background of a script.
TEST(Cancel, IsTestedAlsoWhereTheTestsIgnoreIt) {
  auto* const before = std::signal(SIGINT, SIG_IGN);
  Reading reading;
  std::signal(SIGINT, before);
  expect_ended(reading.run, SIGINT);
}

TEST(Cancel, ErasesTheProgressLine) {
  Reading reading({"--progress", "always"});
  reading.wait_for_line();
  reading.run.signal(SIGINT);
  const std::string err = reading.run.wait().err;
  EXPECT_TRUE(err.starts_with("\repura: reading")) << err;
  EXPECT_TRUE(err.ends_with(" \repura: cancelled\n")) << err;
}

TEST(Cancel, SignalsThatTheParentIgnoresStayIgnored) {
  Reading reading({}, "trap '' INT");
  reading.run.signal(SIGINT);
  reading.give_model();
  const Outcome outcome = reading.run.wait();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(reading.folder.names(), (Names{"model.obj", "x.svg"}));
}

}  // namespace
}  // namespace epura::test::cancel_test
