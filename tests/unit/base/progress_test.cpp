#include "base/progress.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace epura::test {
namespace {

TEST(Progress, MadeFromNothingDoesNothing) {
  const Progress progress;
  progress.begin("anything", 10);
  progress.advance(3);
  EXPECT_FALSE(progress.is_limited());
  EXPECT_FALSE(progress.is_out_of_time());
  EXPECT_FALSE(progress.with_half_the_time().is_limited());
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

TEST(Progress, HalfTheTimeIsOverEarlier) {
  ProgressBoard board;
  const Progress whole(board, 1000);
  const Progress half = whole.with_half_the_time();
  EXPECT_TRUE(half.is_limited());
  EXPECT_FALSE(half.is_out_of_time());
  const Progress soon(board, board.seconds() + 0.2);
  const Progress sooner = soon.with_half_the_time();
  std::this_thread::sleep_for(std::chrono::milliseconds(101));
  EXPECT_TRUE(sooner.is_out_of_time());
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
}  // namespace epura::test
