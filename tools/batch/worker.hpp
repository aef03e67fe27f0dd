// SPDX-License-Identifier: Apache-2.0
// A process that draws jobs one after another. It is a copy of the process that plans the batch, so that a message
// needs to hold only the number of a job.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "batch/batch.hpp"
#include "batch/manifest.hpp"

namespace epura {

/// What the workers of a batch have in common.
struct BatchPlan {
  DrawOptions common;
  std::vector<Job> jobs;
  JobRecords records;                ///< of earlier runs; empty if everything is to be drawn again
  std::string basis;                 ///< hash of what all drawings depend on: options, version, plugins, fonts
  std::optional<double> job_memory;  ///< MB
  std::filesystem::path pictures;    ///< folder for pictures of drawings that browsers cannot show; empty: none
};

/// The hash of the version, the options, and the libraries and fonts in use.
std::string basis_of(const BatchOptions& options);

struct JobResult {
  std::size_t job = 0;
  bool is_unchanged = false;  ///< nothing was drawn; the rest of the record is that of the earlier run
  JobRecord record;
};

/// Draws the jobs whose numbers arrive at a socket, and sends results, until the socket is closed. The process can open
/// only the folders of jobs, unless `--sandbox off`; those of outputs exist.
void serve_jobs(int socket, const BatchPlan& plan);

/// The code of a job whose process ended before the job.
inline constexpr int crashed_exit_code = 70;

/// Draws a job in this process.
JobResult do_job(const BatchPlan& plan, std::size_t job);

/// Unpacks a message of serve_jobs. Throws Error{plugin} if it is damaged.
JobResult unpack_result(const std::string& message);

}  // namespace epura
