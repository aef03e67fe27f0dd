// SPDX-License-Identifier: Apache-2.0
// A run from options to files, without a terminal.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "base/progress.hpp"
#include "pipeline/targets.hpp"
#include "report/report.hpp"
#include "sizes/rebuilt_part.hpp"
#include "views/draw_view.hpp"
#include "views/messages.hpp"

namespace epura {

struct DrawnFiles {
  std::vector<std::string> paths;  ///< written files
  report::Report report;
  std::string answers;  ///< answers to --why, --dump and --explain
  pipeline::Stopwatch watch;
  std::vector<pipeline::FinishedSheet> sheets;  ///< content of the files; takes most of the memory
  std::optional<sheet::RebuiltPart> rebuilt{};  ///< for define

  [[nodiscard]] bool is_wrong() const { return report.verification && !report.verification->is_right(); }
};

/// Returns the exit code of the run: wrong takes precedence over partial.
int exit_code_of(const DrawnFiles& drawn);

/// Draws and writes all files. Throws Error; Error{time} if time runs out before there is a line to show.
DrawnFiles draw_files(const DrawOptions& options, const pipeline::Messages& messages, Progress progress);

/// Makes the scene of a run.
using DescribeScene = std::function<scene::SceneDescription(const Progress&)>;

/// The same for another scene than that of the options.
DrawnFiles draw_files(const DrawOptions& options, const DescribeScene& describe_scene,
                      const pipeline::Messages& messages, Progress progress);

/// The findings about the dimensions of a drawing as JSON (docs/reports.md).
std::string findings_json(const report::Report& report);

/// Prints the result of --timings, and what --time-limit omitted.
void tell_the_end(const pipeline::Messages& messages, const DrawOptions& options, const DrawnFiles& drawn);

}  // namespace epura
