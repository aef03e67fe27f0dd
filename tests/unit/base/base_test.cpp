// SPDX-License-Identifier: Apache-2.0
// Errors, vectors, parallel loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <mutex>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "base/broken.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/vec.hpp"

namespace epura::test::base_test {
namespace {

TEST(Errors, SayPlaceReasonAndRemedy) {
  const Error error(ErrorKind::input, "a.obj:3", "is wrong", "mend it");
  EXPECT_STREQ(error.what(), "a.obj:3: is wrong");
  EXPECT_EQ(error.hint(), "mend it");
  EXPECT_STREQ(Error(ErrorKind::plugin, "", "is wrong").what(), "is wrong");
  EXPECT_EQ(static_cast<int>(ErrorKind::input), 2);
  EXPECT_EQ(static_cast<int>(ErrorKind::plugin), 3);
  EXPECT_EQ(static_cast<int>(ErrorKind::output), 4);
}

TEST(Errors, OurOwnMistakesAreFoundInEveryBuild) {
  check(true, "not said");
  try {
    check(false, "two and two");
    ADD_FAILURE() << "not found";
  } catch (const Broken& error) {
    EXPECT_STREQ(error.what(), "two and two");
  }
}

TEST(Vectors, RowsAreRows) {
  const Mat4 m = rows({1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {0, 0, 0, 1});
  EXPECT_EQ(m * Vec4(1, 0, 0, 1), Vec4(5, 13, 21, 1));
}

TEST(Vectors, BoxesGrowAndHaveACentreAtTheEndOfTheDoubles) {
  Box box;
  EXPECT_TRUE(box.empty());
  box.add({1, -2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.size(), Vec3(0));
  box.add({3, 2, -1});
  EXPECT_EQ(box.centre(), Vec3(2, 0, 1));
  EXPECT_EQ((Box{Vec3(DBL_MAX), Vec3(DBL_MAX)}).centre(), Vec3(DBL_MAX));
}

TEST(Parallel, EveryItemIsVisitedOnce) {
  for (const int threads : {0, 1, 3})
    for (const std::size_t count : {0, 1, 63, 64, 65, 100000}) {
      const ThreadLimit limit(threads);
      std::vector<std::atomic<int>> visits(count);
      parallel_for(count, 64, [&](std::size_t begin, std::size_t end) {
        ASSERT_LE(end, count);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const auto& n : visits) ASSERT_EQ(n, 1);
    }
}

TEST(Parallel, SortSorts) {
  std::mt19937 random(6);
  for (const std::size_t count : {0u, 1u, 8193u, 100000u}) {
    std::vector<unsigned> numbers(count);
    for (unsigned& number : numbers) number = static_cast<unsigned>(random() % 1000);
    std::vector<unsigned> expected = numbers;
    std::sort(expected.begin(), expected.end());
    parallel_sort(numbers.begin(), numbers.end());
    EXPECT_EQ(numbers, expected);
  }
}

TEST(Parallel, OneThreadIsOneThread) {
  const ThreadLimit limit(1);
  std::set<std::thread::id> seen;
  std::mutex mutex;
  parallel_for(100000, 1, [&](std::size_t, std::size_t) {
    const std::lock_guard lock(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(seen.size(), 1U);
}

TEST(Parallel, AnErrorGetsOut) {
  EXPECT_THROW(parallel_for(1000, 1, [](std::size_t, std::size_t) { throw Error(ErrorKind::input, "a", "b"); }), Error);
}

}  // namespace
}  // namespace epura::test::base_test
