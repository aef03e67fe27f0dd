// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <atomic>
#include <latch>
#include <system_error>
#include <thread>
#include <vector>

namespace epura {

namespace {

/// The limits to one thread that there are. For these, oneTBB is not even loaded: for one thread it is not needed, and
/// where memory ends while it loads its own libraries, glibc 2.36 crashes.
std::atomic<int> limits_to_one = 0;

std::size_t thread_limit() {
  if (limits_to_one > 0) return 1;
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

/// If memory or processes are scarce, oneTBB ends the program from one of its own threads: this can only be detected
/// beforehand.
bool can_begin(std::size_t threads) {
  std::latch all_there(1);
  std::vector<std::thread> begun;
  bool can = true;
  try {
    while (begun.size() < threads) begun.emplace_back([&] { all_there.wait(); });
  } catch (const std::system_error&) {
    can = false;
  }
  all_there.count_down();
  for (std::thread& thread : begun) thread.join();
  return can;
}

/// Tried when threads are first wanted: small drawings want none, and asking oneTBB for the number of cores loads a
/// library.
bool may_use_threads() {
  static std::atomic<bool> could_begin = false;
  if (could_begin) return thread_limit() > 1;
  const std::size_t limit = thread_limit();
  if (limit > 1) could_begin = can_begin(limit - 1);
  return could_begin;
}

void for_alone(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  // As small as oneTBB makes them for one thread: stages report their progress between pieces.
  const std::size_t piece = std::max(grain, count / 16);
  for (std::size_t begin = 0; begin < count; begin += piece) body(begin, std::min(begin + piece, count));
}

}  // namespace

void parallel_for(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count <= grain) {
    if (count > 0) body(0, count);
    return;
  }
  if (!may_use_threads()) return for_alone(count, grain, body);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
}

void parallel_both(const std::function<void()>& first, const std::function<void()>& second) {
  if (may_use_threads()) return tbb::parallel_invoke(first, second);
  first();
  second();
}

ThreadLimit::ThreadLimit(int threads) : control_(nullptr) {
  if (threads <= 0) return;
  const auto limit = static_cast<std::size_t>(threads);
  is_to_one_ = limit == 1 || !can_begin(limit - 1);
  if (is_to_one_)
    ++limits_to_one;
  else if (limit != thread_limit())
    control_ = new tbb::global_control(tbb::global_control::max_allowed_parallelism, limit);
}

ThreadLimit::~ThreadLimit() {
  if (is_to_one_) --limits_to_one;
  delete static_cast<tbb::global_control*>(control_);
}

}  // namespace epura
