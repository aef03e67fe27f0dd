// SPDX-License-Identifier: Apache-2.0
// `epura lint`: faults of the dimensions of a drawing.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/draw_files.hpp"
#include "base/text.hpp"
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

std::string json_of(const report::SizeCount& count) {
  return "{\"kind\": " + output::json_string(count.kind) + ", \"given\": " + std::to_string(count.given) +
         ", \"all\": " + std::to_string(count.all) + "}";
}

int missing_in(const std::vector<report::SizeCount>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), 0,
                         [](int missing, const report::SizeCount& one) { return missing + one.all - one.given; });
}

// "sizes: 53 of 56 plane faces, 12 of 12 holes; 3 have none"
std::string sentence_of(const std::vector<report::SizeCount>& sizes) {
  if (sizes.empty()) return "sizes: no faces are counted, only overall sizes and places of parts are checked\n";
  std::string text;
  for (const report::SizeCount& one : sizes)
    append_to_list(text, std::to_string(one.given) + " of " + std::to_string(one.all) + " " + one.kind);
  if (const int missing = missing_in(sizes); missing > 0)
    text += "; " + std::to_string(missing) + (missing == 1 ? " has none" : " have none");
  return "sizes: " + text + "\n";
}

// Of a machine, most sizes have no room.
std::string hint_for_machines(const report::Report& report) {
  constexpr std::size_t many_findings = 40;
  constexpr int many_bodies = 10;
  int bodies = 0;
  for (const mesh::MeshReport& mesh : report.meshes) bodies += mesh.bodies;
  if (report.findings.size() < many_findings || bodies < many_bodies) return "";
  return "  hint: the models have " + std::to_string(bodies) +
         " bodies: draw the parts on sheets of their own, and overall dimensions of the whole\n";
}

// What to add to the command; a scene file has a [[view]] for each.
std::string hint_of(const std::vector<std::string>& views) {
  if (views.empty()) return "";
  std::string text = "  hint: these views show more:";
  for (const std::string& view : views) text += " --projection " + view;
  return text + "\n";
}

// What a finding says apart from numbers: "radius R" of "2× radius R12.5".
std::string pattern_of(const report::Finding& finding) {
  const std::string_view many = "×";
  std::string pattern = sentence_of(finding);
  std::erase_if(pattern, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == ',' || c == '-' || c == ' '; });
  if (const std::size_t at = pattern.find(many); at != std::string::npos) pattern.erase(at, many.size());
  return pattern;
}

// The first ones of those that differ in numbers alone, and how many more there are.
std::string printed_findings(const std::vector<report::Finding>& findings, bool all) {
  constexpr std::size_t max_alike = 3;
  std::map<std::string, std::size_t> alike, told;
  for (const report::Finding& finding : findings) ++alike[pattern_of(finding)];
  std::string text;
  for (const report::Finding& finding : findings) {
    const std::string pattern = pattern_of(finding);
    const std::size_t count = alike[pattern], number = ++told[pattern];
    // A line for the rest would not be shorter than the only one that it stands for.
    const bool is_told = all || number <= max_alike || count == max_alike + 1;
    if (is_told) text += sentence_of(finding);
    if (!is_told && number == count)
      text += name_of(finding) + ": " + std::to_string(count - max_alike) +
              " more that differ in numbers from: " + finding.what + " (--all lists them)\n";
  }
  return text;
}

}  // namespace

std::string findings_json(const report::Report& report) {
  const auto write = [](const report::Finding& finding) { return json_of(finding); };
  return "{\"epura_lint\": 1, \"findings\": " + output::json_lines(report.findings, write, "\n  ") +
         ", \"sizes\": " + output::json_list(report.sizes, [](const report::SizeCount& one) { return json_of(one); }) +
         ", \"views_to_add\": " + output::json_list(report.views_to_add, output::json_string) + "}\n";
}

int lint(DrawOptions options) {
  options.run.lint = true;
  options.run.free_faces = options.lint_free_faces;
  if (!options.lint_json.empty()) pipeline::refuse_overwriting({options.lint_json}, options.models);
  ProgressBoard board;
  Console console(board, shows_progress(options.progress), options.run.time_limit);
  const DrawnFiles drawn = draw_files(options, messages_to(console), Progress(board, options.run.time_limit));
  console.print("");
  tell_the_end(messages_to(console), options, drawn);
  const std::vector<report::Finding>& findings = drawn.report.findings;
  if (!options.lint_json.empty()) pipeline::write({options.lint_json, findings_json(drawn.report)}, {});
  if (options.lint_json != "-") {
    std::fputs(printed_findings(findings, options.lint_all).c_str(), stdout);
    std::fputs((hint_for_machines(drawn.report) + hint_of(drawn.report.views_to_add)).c_str(), stdout);
    std::fputs(sentence_of(drawn.report.sizes).c_str(), stdout);
  }
  const int code = exit_code_of(drawn);
  return code == 0 && (missing_in(drawn.report.sizes) > 0 || !findings.empty()) ? found_wrong_exit_code : code;
}

}  // namespace epura
