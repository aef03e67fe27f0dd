// SPDX-License-Identifier: Apache-2.0
// base/parallel.hpp for tests: linked in place of the one of src/ground/base, with a schedule that is drawn by lot.
//
// The number of threads given to ThreadLimit is the seed; 0 is one piece after the other in order. Ranges are cut at
// random places, also into pieces shorter than `grain`, so that small scenes are cut, too. The pieces run in random
// order: for even seeds one after the other, which repeats exactly, for odd ones on three threads.
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "base/parallel.hpp"

namespace epura {

namespace {

using Random = std::mt19937;
using Tasks = std::vector<std::function<void()>>;

// What ThreadLimit sets has no other place: loops are called from everywhere.
std::atomic<int> seed = 0;
std::atomic<unsigned> loops = 0;

Random next_random() {
  return Random(1000003U * static_cast<unsigned>(seed) + loops.fetch_add(1, std::memory_order_relaxed));
}

// Runs all tasks and throws the first exception that one of them threw. Which thread runs which is settled beforehand:
// threads that took turns would be ordered by that, and the thread sanitizer would see no race between them.
void run(const Tasks& tasks) {
  const std::size_t workers = seed % 2 == 1 ? std::min<std::size_t>(3, tasks.size()) : 1;
  std::mutex mutex;
  std::exception_ptr kind;
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < tasks.size(); i += workers) try {
        tasks[i]();
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!kind) kind = std::current_exception();
      }
  };
  std::vector<std::thread> others;
  for (std::size_t worker = 1; worker < workers; ++worker) others.emplace_back(work, worker);
  work(0);
  for (std::thread& thread : others) thread.join();
  if (kind) std::rethrow_exception(kind);
}

// 0, some places between in rising order, and `count`.
std::vector<std::size_t> random_cuts(Random& random, std::size_t count) {
  std::vector<std::size_t> cuts{0, count};
  const std::size_t pieces = 2 + random() % 15;
  for (std::size_t i = 1; i < pieces; ++i) cuts.push_back(random() % count);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

}  // namespace

void parallel_for(std::size_t count, std::size_t, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  if (seed == 0) return body(0, count);
  Random random = next_random();
  const std::vector<std::size_t> cuts = random_cuts(random, count);
  Tasks tasks;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    tasks.emplace_back([&body, begin = cuts[i - 1], end = cuts[i]] { body(begin, end); });
  std::shuffle(tasks.begin(), tasks.end(), random);
  run(tasks);
}

void parallel_both(const std::function<void()>& first, const std::function<void()>& second) {
  const bool turned = seed != 0 && next_random()() % 2 == 1;
  run(turned ? Tasks{second, first} : Tasks{first, second});
}

ThreadLimit::ThreadLimit(int threads) : control_(nullptr) {
  seed = threads;
  loops = 0;
}

ThreadLimit::~ThreadLimit() { seed = 0; }

}  // namespace epura
