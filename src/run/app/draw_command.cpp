// SPDX-License-Identifier: Apache-2.0
// `epura draw`: a run on a terminal.
#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/confinement.hpp"
#include "app/console.hpp"
#include "app/draw_files.hpp"
#include "app/jobs/jobs.hpp"
#include "app/jobs/placeholders.hpp"

namespace epura {

int exit_code_of(const DrawnFiles& drawn) {
  if (drawn.is_wrong() || drawn.report.cut_off || drawn.report.unmatched_sizes) return found_wrong_exit_code;
  const std::vector<report::RequirementRow>& rows = drawn.report.requirements;
  const auto is_missing = [](const report::RequirementRow& row) { return row.is_missing(); };
  if (std::any_of(rows.begin(), rows.end(), is_missing)) return found_wrong_exit_code;
  return drawn.report.partial.stages.empty() ? 0 : partial_exit_code;
}

namespace {

// Messages go to standard error, since the drawing may go to standard output.
int draw_once(const DrawOptions& options) {
  ProgressBoard board;
  Console console(board, shows_progress(options.progress), options.run.time_limit);
  const pipeline::Messages messages = messages_to(console);
  DrawnFiles drawn = draw_files(options, messages, Progress(board, options.run.time_limit));
  console.print("");  // erases the progress line
  std::fputs(drawn.answers.c_str(), stdout);
  tell_the_end(messages, options, drawn);
  // Deliberately not freed: a million small blocks of memory are released at once when the program ends.
  static_cast<void>(new std::vector<pipeline::FinishedSheet>(std::move(drawn.sheets)));
  return exit_code_of(drawn);
}

// One drawing for each model, since outputs are named after models.
int draw_each(const DrawOptions& options) {
  JobSources sources;
  sources.draw = options;
  for (const std::string& output : options.outputs)
    sources.later.push_back({"-o,--output", scene::value_of_option("--output", output)});
  const auto [jobs, passed_over] = plan_jobs(sources);
  if (!passed_over.empty()) {
    ProgressBoard board;
    Console(board, false).warn(passed_over);
  }
  for (const Job& job : jobs) create_folders(job.outputs);
  confine_if_asked(options, files_of(jobs));
  int code = 0;
  for (const Job& job : jobs) code = std::max(code, draw_once(options_of(job, options)));
  return code;
}

}  // namespace

int draw(const DrawOptions& options) {
  const bool is_named_after_model = std::any_of(options.outputs.begin(), options.outputs.end(), has_placeholder);
  if (is_named_after_model) return draw_each(options);
  std::vector<std::string> read = options.models;
  if (options.revise.given()) read.push_back(*options.revise);
  confine_if_asked(options, {read, options.outputs});
  return draw_once(options);
}

}  // namespace epura
