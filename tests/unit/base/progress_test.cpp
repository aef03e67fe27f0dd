// SPDX-License-Identifier: Apache-2.0
#include "base/progress.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "base/parallel.hpp"

namespace epura::test::progress_test {
namespace {

TEST(Progress, MadeFromNothingDoesNothing) {
  const Progress progress;
  progress.begin("anything", 10);
  progress.advance(3);
  EXPECT_FALSE(progress.is_limited());
  EXPECT_FALSE(progress.is_out_of_time());
  EXPECT_FALSE(progress.with_part_of_the_time(0.5).is_limited());
  EXPECT_NO_THROW(progress.expect_time());
  EXPECT_FALSE(progress.undisturbed().owns_lock());
}

TEST(Progress, ManyThreadsAddUp) {
  ProgressBoard board;
  const Progress progress(board);
  progress.begin("counting", 8000);
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([progress] {
      for (int i = 0; i < 500; ++i) progress.advance(2);
    });
  for (std::thread& thread : threads) thread.join();
  const Standing standing = board.standing();
  EXPECT_EQ(standing.stage, "counting");
  EXPECT_EQ(standing.work, 8000U);
  EXPECT_EQ(standing.done, 8000U);
}

TEST(Progress, IsToldOncePerPercent) {
  std::vector<double> told;
  ProgressBoard board;
  board.observe({.tell = [&](const std::string&, double part) { told.push_back(part); }});
  const Progress progress(board);
  progress.begin("counting", 1000);
  for (int i = 0; i < 1000; ++i) progress.advance(1);
  ASSERT_EQ(told.size(), 101U);
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_NEAR(told[i], double(i) / 100, 1.5e-3);
}

TEST(Progress, AStageBeginsAnew) {
  ProgressBoard board;
  const Progress progress(board);
  progress.begin("one", 5);
  progress.advance(5);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_GE(board.standing().seconds, 0.02);
  const double before = board.seconds();
  progress.begin("two");
  const Standing standing = board.standing();
  EXPECT_EQ(standing.stage, "two");
  EXPECT_EQ(standing.done, 0U);
  EXPECT_EQ(standing.work, 0U);
  EXPECT_LE(standing.seconds, board.seconds() - before);
}

TEST(Progress, TimeIsOverOnceTheLimitIsReached) {
  ProgressBoard board;
  EXPECT_TRUE(Progress(board, 0).is_out_of_time());
  EXPECT_FALSE(Progress(board, 1e300).is_out_of_time());
  const Progress progress(board, 0.05);
  while (board.seconds() < 0.05) EXPECT_TRUE(progress.is_limited());
  EXPECT_TRUE(progress.is_out_of_time());
}

TEST(Progress, APartOfTheTimeIsOverEarlier) {
  double now = 10;
  ProgressBoard board([&] { return now; });
  const Progress progress(board, 20);
  const Progress part = progress.with_part_of_the_time(0.25);
  const Progress more = progress.with_more_time(5);
  now = 12.4;
  EXPECT_FALSE(part.is_out_of_time());
  now = 12.5;
  EXPECT_TRUE(part.is_out_of_time());
  EXPECT_FALSE(progress.is_out_of_time());
  now = 24;
  EXPECT_TRUE(progress.is_out_of_time());
  EXPECT_FALSE(more.is_out_of_time());
  EXPECT_FALSE(progress.without_limit().is_out_of_time());
}

TEST(Progress, OutOfTimeNamesTheStage) {
  ProgressBoard board;
  const Progress progress(board, 0);
  progress.begin("sawing");
  try {
    progress.expect_time();
    FAIL();
  } catch (const OutOfTime& cut) {
    EXPECT_EQ(cut.stage, "sawing");
  }
}

TEST(Progress, LoopsLookAtTheClockBeforeEveryPiece) {
  std::atomic<int> looks = 0;
  ProgressBoard board([&] { return ++looks <= 5 ? 0.0 : 1.0; });
  const ThreadLimit alone(1);
  std::size_t done = 0;
  const auto count = [&](std::size_t begin, std::size_t end) { done += end - begin; };
  EXPECT_THROW(parallel_for(1000, 10, Progress(board, 1), count), OutOfTime);
  EXPECT_LE(done, 50U);
  EXPECT_GT(done, 0U);
  parallel_for(1000, 10, Progress(), count);
  EXPECT_GE(done, 1000U);
}

TEST(Progress, APaceLooksAtTheClockOnceInAWhile) {
  int looks = 0;
  ProgressBoard board([&] { return ++looks <= 3 ? 0.0 : 1.0; });
  const Progress progress(board, 1);
  progress.begin("walking", 10000);
  Pace pace(progress, 10000);
  std::size_t left = 10000;
  EXPECT_THROW(while (left > 0) pace.left(--left), OutOfTime);
  EXPECT_EQ(left, 10000U - 4 * 1024);
  EXPECT_EQ(board.standing().done, 4 * 1024U);
}

TEST(Progress, WhatDoesNotFitIsMadeOfLess) {
  double now = 0;
  ProgressBoard board([&] { return now; });
  int work = 64;
  const auto make = [&](const Progress& progress) {
    for (int i = 0; i < work; ++i) {
      progress.expect_time();
      now += 1;
    }
    return work;
  };
  std::vector<int> left;
  const auto leave_out = [&](const std::string&) {
    left.push_back(work /= 8);
    return work < 2;
  };
  const Progress progress(board, 32);
  EXPECT_EQ(make_in_time(progress, progress.with_more_time(4), make, leave_out), 1) << "8 do not fit into 2";
  EXPECT_EQ(left, (std::vector<int>{8, 1}));
}

TEST(Progress, UndisturbedKeepsOthersFromEndingTheRun) {
  ProgressBoard board;
  {
    const auto lock = Progress(board).undisturbed();
    std::thread([&] { EXPECT_FALSE(board.ending().try_lock()); }).join();
  }
  EXPECT_TRUE(board.ending().try_lock());
  board.ending().unlock();
}

TEST(Progress, TheRestTakesAsLongAsTheSpeedSoFarTells) {
  EXPECT_EQ(seconds_left({"", 25, 100, 2}), 6.0);
  EXPECT_EQ(seconds_left({"", 100, 100, 2}), 0.0);
  EXPECT_EQ(seconds_left({"", 0, 100, 2}), std::nullopt) << "no speed yet";
  EXPECT_EQ(seconds_left({"", 7, 0, 2}), std::nullopt) << "unknown work";
}

}  // namespace
}  // namespace epura::test::progress_test
