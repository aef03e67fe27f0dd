// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "output/write.hpp"
#include "pipeline/targets.hpp"
#include "report/report.hpp"
#include "study/commands.hpp"
#include "study/report_targets.hpp"
#include "study/stability/write.hpp"
#include "views/choose.hpp"

namespace epura::study {

namespace {

enum class StabilityFormat { html, json, csv, svg, pdf };

using Targets = std::vector<ReportTarget<StabilityFormat>>;

Targets targets_of(const StabilityOptions& options) {
  return report_targets<StabilityFormat>(options.outputs, options.format,
                                         {{"html", StabilityFormat::html},
                                          {"json", StabilityFormat::json},
                                          {"csv", StabilityFormat::csv},
                                          {"svg", StabilityFormat::svg},
                                          {"pdf", StabilityFormat::pdf}});
}

std::vector<stability::Case> chosen_cases(const std::string& ids) {
  std::vector<stability::Case> all = stability::all_cases();
  if (ids.empty()) return all;
  std::vector<std::pair<std::string, const stability::Case*>> by_id;
  for (const stability::Case& one : all) by_id.emplace_back(one.id, &one);
  std::vector<stability::Case> chosen;
  for (const std::string_view id : split(ids, ','))
    chosen.push_back(*pipeline::choose<const stability::Case*>("--cases", std::string(id), by_id));
  return chosen;
}

std::string encode(const stability::Report& report, StabilityFormat format, bool timings) {
  switch (format) {
    case StabilityFormat::html:
      return to_html(report);
    case StabilityFormat::json:
      return to_json(report, timings);
    case StabilityFormat::csv:
      return to_csv(report);
    case StabilityFormat::svg:
      return output::to_svg(to_sheet(report), {});
    case StabilityFormat::pdf:
      break;
  }
  const sheet::Sheet sheet = to_sheet(report);
  return output::to_pdf({&sheet});
}

void print_timings(Console& console, const stability::Report& report) {
  for (const stability::CaseReport& one : report) console.print(one.id + " " + format_fixed(one.seconds, 3) + " s\n");
}

// There is one arithmetic and nothing to plot.
void study_limits(const StabilityOptions& options) {
  if (!options.outputs.empty())
    throw Error(ErrorKind::input, "--beyond", "it prints a table and writes no report", "omit -o");
  ProgressBoard board;
  Console console(board, shows_progress(options.progress));
  const ThreadLimit threads(options.threads);
  const std::vector<stability::Case> cases = chosen_cases(options.cases);
  const auto limits = stability::find_limits(cases, options.size, options.beyond, Progress(board));
  console.print("");  // clears the progress line
  std::fputs(stability::to_text(limits).c_str(), stdout);
}

}  // namespace

int study_stability(const StabilityOptions& options) {
  if (options.beyond > 0) {
    study_limits(options);
    return 0;
  }
  ProgressBoard board;
  Console console(board, shows_progress(options.progress));
  const Progress progress(board);
  const ThreadLimit threads(options.threads);
  const Targets targets = targets_of(options);
  pipeline::refuse_overwriting(options.outputs, {});
  const std::vector<stability::Case> cases = chosen_cases(options.cases);
  const stability::Report report = stability::run(cases, options.size, progress);

  bool to_stdout = false;
  for (const ReportTarget<StabilityFormat>& target : targets) {
    pipeline::write({target.path, encode(report, target.format, options.timings)}, progress);
    to_stdout = to_stdout || target.path == "-";
  }
  console.print("");  // clears the progress line
  if (!to_stdout) std::fputs(to_text(report, !options.cases.empty()).c_str(), stdout);
  if (options.timings) print_timings(console, report);
  const bool broken = std::any_of(report.begin(), report.end(), [](const stability::CaseReport& one) {
    return one.verdict() == stability::Verdict::broken;
  });
  return broken ? found_wrong_exit_code : 0;
}

}  // namespace epura::study
