// SPDX-License-Identifier: Apache-2.0
// A batch in parts, one for each machine or task of a scheduler.
#pragma once

#include <string>
#include <vector>

#include "app/jobs/jobs.hpp"

namespace epura {

struct Shard {
  int number = 1, count = 1;  ///< from 1

  [[nodiscard]] bool is_whole() const { return count == 1; }
  auto operator<=>(const Shard&) const = default;
};

/// Reads "2/8", or "auto": the number that Slurm, Grid Engine or AWS Batch gives to an element of an array of jobs; or
/// "auto/8" where only the number is given, as by Kubernetes (JOB_COMPLETION_INDEX). An empty text is all. Throws
/// Error{input}.
Shard parse_shard(const std::string& text);

/// Returns for each job the number of its shard, from 1: longest jobs first, each to the shard with the least work.
/// Depends on the jobs and the number of shards alone, so that all machines divide the batch in the same way.
std::vector<int> shards_of(const std::vector<Job>& jobs, int count);

}  // namespace epura
