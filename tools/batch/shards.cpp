// SPDX-License-Identifier: Apache-2.0
#include "batch/shards.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

constexpr int max_shards = 1'000'000;

// Environment variables of a scheduler. Elements of an array of jobs count from `first` to `last` in steps.
struct Scheduler {
  const char *index, *first, *last, *step, *count;  // null: there is no such variable
};

constexpr std::array schedulers{
    Scheduler{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", nullptr, "SLURM_ARRAY_TASK_STEP",
              "SLURM_ARRAY_TASK_COUNT"},
    Scheduler{"AWS_BATCH_JOB_ARRAY_INDEX", nullptr, nullptr, nullptr, "AWS_BATCH_JOB_ARRAY_SIZE"},
    Scheduler{"JOB_COMPLETION_INDEX", nullptr, nullptr, nullptr, nullptr},
    Scheduler{"SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE", nullptr}};

std::optional<long long> number_in(const char* variable) {
  const char* text = variable != nullptr ? std::getenv(variable) : nullptr;
  return text != nullptr ? parse_integer(text) : std::nullopt;
}

[[noreturn]] void refuse(const std::string& text, const std::string& reason) {
  throw Error(ErrorKind::input, "--shard " + text, reason,
              "write 2/8 for the second of eight parts, or auto in an array of jobs");
}

std::optional<long long> count_in(const Scheduler& scheduler) {
  if (const auto count = number_in(scheduler.count)) return count;
  const auto last = number_in(scheduler.last);
  return last ? std::optional((*last - number_in(scheduler.first).value_or(1)) /
                                  std::max(number_in(scheduler.step).value_or(1), 1LL) +
                              1)
              : std::nullopt;
}

std::pair<long long, long long> shard_of_scheduler(const std::string& text, std::optional<long long> given_count) {
  for (const Scheduler& scheduler : schedulers) {
    // Grid Engine sets "undefined" outside arrays.
    const auto index = number_in(scheduler.index);
    if (!index) continue;
    const auto count = given_count ? given_count : count_in(scheduler);
    if (!count) refuse(text, std::string("the number of parts is not in the environment beside ") + scheduler.index);
    const long long step = std::max(number_in(scheduler.step).value_or(1), 1LL);
    return {(*index - number_in(scheduler.first).value_or(0)) / step + 1, *count};
  }
  refuse(text, "no scheduler has numbered this job in its environment");
}

}  // namespace

Shard parse_shard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const std::string before = text.substr(0, slash);
  std::optional<long long> count;
  if (slash != std::string::npos) count = parse_integer(text.substr(slash + 1));
  if (slash != std::string::npos && !count) refuse(text, "has no number of parts");
  std::pair<long long, long long> found;
  if (before == "auto") {
    found = shard_of_scheduler(text, count);
  } else {
    const auto number = parse_integer(before);
    if (!number || !count) refuse(text, "is not a part of a batch");
    found = {*number, *count};
  }
  if (found.second < 1 || found.second > max_shards || found.first < 1 || found.first > found.second)
    refuse(text, "part " + std::to_string(found.first) + " of " + std::to_string(found.second) + " does not exist");
  return {static_cast<int>(found.first), static_cast<int>(found.second)};
}

std::vector<int> shards_of(const std::vector<Job>& jobs, int count) {
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return jobs[a].estimate > jobs[b].estimate; });
  using Load = std::pair<double, int>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (int shard = 1; shard <= count; ++shard) loads.emplace(0, shard);
  std::vector<int> shards(jobs.size());
  for (const std::size_t job : order) {
    const auto [load, shard] = loads.top();
    loads.pop();
    loads.emplace(load + jobs[job].estimate, shard);
    shards[job] = shard;
  }
  return shards;
}

}  // namespace epura
