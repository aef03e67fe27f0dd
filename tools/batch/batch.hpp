// SPDX-License-Identifier: Apache-2.0
// `epura batch`: many drawings, each in a process of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/jobs/jobs.hpp"
#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

struct BatchOptions {
  JobSources sources;
  std::vector<std::string> words;    ///< options that change drawings, as given
  bool again = false;                ///< draw what has not changed, too
  bool resume = false;               ///< only if there is a manifest
  std::string manifest;              ///< empty: beside the outputs
  std::string merge;                 ///< manifest whose parts are joined, instead of drawing; or its folder
  std::string shard;                 ///< "2/8", or "auto" for the number that the scheduler gives
  std::string report, junit;         ///< files to write; empty: none
  int workers = 0;                   ///< number of jobs at the same time; 0: one for each core
  std::optional<double> job_time;    ///< seconds
  std::optional<double> job_memory;  ///< MB
  ShowProgress progress = ShowProgress::automatic;
};

/// The options of its jobs, and its own.
scene::Options<BatchOptions> batch_options();

/// Returns the exit code.
int batch(const BatchOptions& options);

}  // namespace epura
