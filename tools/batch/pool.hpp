// SPDX-License-Identifier: Apache-2.0
// Runs jobs in several processes. A job that crashes, hangs or fills the memory ends its own process only.
#pragma once

#include <functional>
#include <optional>

#include "batch/worker.hpp"

namespace epura {

struct PoolLimits {
  int workers = 1;
  std::optional<double> job_seconds;
};

/// Does the jobs with these numbers, the longest first, and calls `take(result)` as they end. Throws Error{plugin} if
/// no process can be started.
void do_jobs(const BatchPlan& plan, std::vector<std::size_t> numbers, const PoolLimits& limits,
             const std::function<void(JobResult)>& take);

}  // namespace epura
