// SPDX-License-Identifier: Apache-2.0
// The jobs of a batch: what is drawn, and to which files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "scene/option.hpp"
#include "scene/toml_tree.hpp"

namespace epura {

/// An option whose value is not read before the job is known.
struct LaterOption {
  std::string flag;  ///< as in the table of options
  scene::TomlValue value;
};

/// What jobs are planned from.
struct JobSources {
  DrawOptions draw;                 ///< what all jobs have in common, and in `models` the sources
  std::vector<LaterOption> later;   ///< options with placeholders
  std::vector<std::string> tables;  ///< files with a job in each row
};

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

struct JobPlan {
  std::vector<Job> jobs;
  std::string passed_over;  ///< a sentence about models in folders that are not drawn, or empty
};

/// Returns all jobs in the order of the command line. Throws Error{input} for sources without models, unknown columns
/// and placeholders, and for two jobs with one output.
JobPlan plan_jobs(const JobSources& sources);

/// Creates the folders of outputs. Throws Error{output}.
void create_folders(const std::vector<std::string>& outputs);

/// Returns the options of a job. Throws Error{input} for wrong values.
DrawOptions options_of(const Job& job, const DrawOptions& common);

/// An estimate in microseconds, from the number of triangles: that in the header of STL, PLY and OFF, otherwise from
/// the size of the file. What matters is the order of jobs, and that it is the same on all machines.
double estimated_time(const std::vector<std::string>& models);

}  // namespace epura
