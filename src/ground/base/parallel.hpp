// SPDX-License-Identifier: Apache-2.0
// Parallel loops. Results must not depend on how the range is divided.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "base/progress.hpp"

namespace epura {

/// How many items make a piece of a loop, by what one of them costs: handing a piece out takes microseconds, and the
/// clock is looked at between pieces. Loops over fewer items stay on one thread.
namespace grain {
inline constexpr std::size_t light = 8192;   ///< tens of nanoseconds: a sum, a comparison
inline constexpr std::size_t medium = 1024;  ///< up to a microsecond
inline constexpr std::size_t heavy = 64;     ///< microseconds: a search, a fit
}  // namespace grain

/// Calls `body(begin, end)` on disjoint pieces that cover [0, count), at least `grain` long, on several threads.
void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// The same in pieces of at most `grain`; the clock is checked before each. Throws OutOfTime.
inline void parallel_for(std::size_t count, std::size_t grain, const Progress& progress,
                         const std::function<void(std::size_t, std::size_t)>& body) {
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; at += grain) {
      progress.expect_time();
      body(at, std::min(at + grain, end));
    }
  });
}

/// Calls both, possibly at the same time.
void parallel_both(const std::function<void()>& first, const std::function<void()>& second);

/// Sorts both halves in parallel and merges them. Items of which neither is less than the other must be identical.
template <class Iterator>
void parallel_sort(Iterator begin, Iterator end) {
  constexpr int alone = 8192;  // number of items that one thread sorts alone
  if (end - begin <= alone) return std::sort(begin, end);
  const Iterator middle = begin + (end - begin) / 2;
  parallel_both([&] { parallel_sort(begin, middle); }, [&] { parallel_sort(middle, end); });
  std::inplace_merge(begin, middle, end);
}

/// Limits the number of threads during its lifetime; 0 means all cores. If that many threads cannot be started, one
/// does the work, with the same result.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;
  ~ThreadLimit();

 private:
  // Unused in tests/schedules, where nothing is limited.
  [[maybe_unused]] void* control_;
  [[maybe_unused]] bool is_to_one_ = false;
};

}  // namespace epura
