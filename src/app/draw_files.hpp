// SPDX-License-Identifier: Apache-2.0
// One run from options to files, without a terminal.
#pragma once

#include <string>
#include <vector>

#include "app/options.hpp"
#include "base/progress.hpp"
#include "pipeline/draw_view.hpp"
#include "pipeline/messages.hpp"
#include "pipeline/targets.hpp"
#include "report/report.hpp"

namespace epura {

struct DrawnFiles {
  std::vector<std::string> paths;  ///< that were written
  report::Report report;
  std::string answers;  ///< to --why and --dump
  pipeline::Stopwatch watch;
  std::vector<pipeline::FinishedSheet> sheets;  ///< what the files show; theirs is most of the memory

  [[nodiscard]] bool is_wrong() const { return report.verification && !report.verification->is_right(); }
};

/// Of the run: wrong goes before partial.
int exit_code_of(const DrawnFiles& drawn);

/// Draws and writes all files. Throws Error: Error{time} where time is over before there is a line to show.
DrawnFiles draw_files(const DrawOptions& options, const pipeline::Messages& messages, Progress progress);

/// Prints the results of --timings and --verify, and what --time-limit omitted.
void tell_the_end(const pipeline::Messages& messages, const DrawOptions& options, const DrawnFiles& drawn);

}  // namespace epura
