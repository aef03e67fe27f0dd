// SPDX-License-Identifier: Apache-2.0
// The jobs of a batch: what is drawn, and to which files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

/// One run of `epura draw`.
struct Job {
  std::string name;                   ///< the first model
  std::vector<std::string> models;    ///< or one scene file
  std::vector<std::string> outputs;   ///< never empty
  std::vector<LaterOption> settings;  ///< options of this job alone
  double estimate = 0;                ///< of its time, in relative units
};

/// The options of `epura draw` that a job may have.
scene::Options<DrawOptions> job_options();

/// Returns all jobs in the order of the command line. Throws Error{input} for sources without models, unknown columns
/// and placeholders, and for two jobs with one output.
std::vector<Job> plan_jobs(const BatchOptions& options);

/// Returns the options of a job. Throws Error{input} for wrong values.
DrawOptions options_of(const Job& job, const DrawOptions& common);

}  // namespace epura
