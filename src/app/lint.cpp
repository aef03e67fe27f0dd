// SPDX-License-Identifier: Apache-2.0
// `epura lint`: faults of the dimensions of a drawing.
#include <cstdio>
#include <string>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/draw_files.hpp"
#include "output/json_text.hpp"
#include "pipeline/targets.hpp"

namespace epura {

namespace {

std::string name_of(const report::Finding& finding) {
  return report::finding_names[static_cast<std::size_t>(finding.kind)];
}

std::string sentence_of(const report::Finding& finding) {
  const std::string view = finding.view.empty() ? "" : " (view '" + finding.view + "')";
  return name_of(finding) + ": " + finding.what + view + "\n";
}

std::string json_of(const report::Finding& finding) {
  std::string text = "{\"kind\": " + output::json_string(name_of(finding));
  if (!finding.view.empty()) text += ", \"view\": " + output::json_string(finding.view);
  return text + ", \"what\": " + output::json_string(finding.what) + "}";
}

std::string json_of(const std::vector<report::Finding>& findings) {
  const auto write = [](const report::Finding& finding) { return json_of(finding); };
  return "{\"epura_lint\": 1, \"findings\": " + output::json_lines(findings, write, "\n  ") + "}\n";
}

}  // namespace

int lint(DrawOptions options) {
  options.run.lint = true;
  if (!options.lint_json.empty()) pipeline::refuse_overwriting({options.lint_json}, options.models);
  ProgressBoard board;
  Console console(board, shows_progress(options.progress), options.run.time_limit);
  const DrawnFiles drawn = draw_files(options, messages_to(console), Progress(board, options.run.time_limit));
  console.print("");
  tell_the_end(messages_to(console), options, drawn);
  const std::vector<report::Finding>& findings = drawn.report.findings;
  if (!options.lint_json.empty()) pipeline::write({options.lint_json, json_of(findings)}, {});
  if (options.lint_json != "-") {
    for (const report::Finding& finding : findings) std::fputs(sentence_of(finding).c_str(), stdout);
    if (findings.empty()) std::fputs("every recognised size has one dimension, and none cross\n", stdout);
  }
  const int code = exit_code_of(drawn);
  return code == 0 && !findings.empty() ? found_wrong_exit_code : code;
}

}  // namespace epura
