// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>
#include <vector>

#include "app/console.hpp"
#include "base/parallel.hpp"
#include "study/commands.hpp"
#include "study/paper/report.hpp"
#include "views/choose.hpp"

namespace epura::study {

namespace {

std::vector<PaperScene> chosen_scenes(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, PaperScene>> all;
  for (const ClosedForm& form : closed_forms()) all.emplace_back(form.name, scene_of(form));
  std::vector<PaperScene> chosen;
  for (const std::string& name : names) chosen.push_back(pipeline::choose("--body", name, all));
  if (names.empty())
    for (auto& [name, scene] : all) chosen.push_back(std::move(scene));
  return chosen;
}

// Each twice as fine as the one before.
std::vector<int> finenesses_up_to(int finest) {
  constexpr int coarsest = 12;
  std::vector<int> all;
  for (int around = coarsest; around <= finest; around *= 2) all.push_back(around);
  return all;
}

}  // namespace

int study_paper(const PaperOptions& options) {
  ProgressBoard board;
  Console console(board, shows_progress(options.progress));
  const Progress progress(board);
  const ThreadLimit threads(options.threads);
  const auto targets = report_targets(options.outputs);
  PaperStudy study{options.plugin_path};
  study.rivals = options.rivals;
  const std::vector<PaperSeries> measured =
      measure_paper(chosen_scenes(options.bodies), finenesses_up_to(options.finest), options.runs, study, progress);
  write_report(report_of(measured), targets, {}, progress);
  console.print("");  // clears the progress line
  return 0;
}

}  // namespace epura::study
