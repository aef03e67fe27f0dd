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
#include "base/error.hpp"
#include "base/text.hpp"
#include "output/json_text.hpp"
#include "pipeline/targets.hpp"

namespace epura {

namespace {

using report::Axis;

std::string axis_name(Axis axis) { return report::axis_names[static_cast<std::size_t>(axis)]; }

std::string sentence_of(const report::Finding& finding) {
  const std::string view = finding.view.empty() ? "" : " (view '" + finding.view + "')";
  const std::string accepted = finding.accepted.empty() ? "" : " (accepted: " + finding.accepted + ")";
  return std::string(finding.row().name) + ": " + finding.what + view + accepted + "\n";
}

// Schema: lint.schema.json.
std::string json_of(const report::Finding& finding) {
  std::string text = "{\"kind\": " + output::json_string(finding.row().name) +
                     ", \"axis\": " + output::json_string(axis_name(finding.row().axis)) +
                     ", \"fault\": " + (finding.is_fault() ? "true" : "false");
  if (!finding.view.empty()) text += ", \"view\": " + output::json_string(finding.view);
  if (finding.face > 0) text += ", \"face\": " + std::to_string(finding.face);
  if (!finding.accepted.empty()) text += ", \"accepted\": " + output::json_string(finding.accepted);
  return text + ", \"what\": " + output::json_string(finding.what) + "}";
}

// What is not known is left out.
std::string json_of(const report::RequirementRow& row) {
  std::string text = "{\"model\": " + output::json_string(row.model) + ", \"id\": " + output::json_string(row.id) +
                     ", \"kind\": " + output::json_string(row.kind) + ", \"what\": " + output::json_string(row.what) +
                     ", \"wanted\": " + (row.wanted ? "true" : "false");
  if (!row.view.empty()) text += ", \"view\": " + output::json_string(row.view);
  if (row.sheet > 0) text += ", \"sheet\": " + std::to_string(row.sheet);
  if (!row.zone.empty()) text += ", \"sheet_zone\": " + output::json_string(row.zone);
  if (!row.why.empty()) text += ", \"reason\": " + output::json_string(row.why);
  return text + "}";
}

std::string json_of(const report::SizeCount& count) {
  return "{\"kind\": " + output::json_string(count.kind) + ", \"given\": " + std::to_string(count.given) +
         ", \"unsure\": " + std::to_string(count.unsure) + ", \"all\": " + std::to_string(count.all) + "}";
}

/// How many findings on an axis there are.
struct AxisCount {
  int faults = 0, accepted = 0, undecided = 0;
};

AxisCount count_on(Axis axis, const std::vector<report::Finding>& findings) {
  AxisCount count;
  for (const report::Finding& finding : findings)
    if (finding.row().axis == axis)
      ++(finding.is_fault() ? count.faults : finding.accepted.empty() ? count.undecided : count.accepted);
  return count;
}

int missing_in(const std::vector<report::SizeCount>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), 0,
                         [](int missing, const report::SizeCount& one) { return missing + one.missing(); });
}

// "53 of 56 plane faces, 12 of 12 holes; 3 have none"
std::string text_of(const std::vector<report::SizeCount>& sizes) {
  const auto any = [&sizes](std::string_view word) {
    return std::any_of(sizes.begin(), sizes.end(), [word](const auto& one) {
      return std::string_view(one.kind).find(word) != std::string_view::npos;
    });
  };
  if (sizes.empty()) return "no faces are counted, only overall sizes are checked";  // none is recognised
  std::string text;
  int unsure = 0;
  for (const report::SizeCount& one : sizes) {
    append_to_list(text, std::to_string(one.given) + " of " + std::to_string(one.all) + " " + one.kind);
    unsure += one.unsure;
  }
  if (any("places of parts"))
    append_to_list(text, "the faces of parts are not counted, they are for drawings of their own");
  else if (!any("faces"))
    append_to_list(text, "no faces are counted");
  if (const int missing = missing_in(sizes); missing > 0)
    text += "; " + std::to_string(missing) + (missing == 1 ? " has none" : " have none");
  if (unsure > 0) text += "; of " + std::to_string(unsure) + " nobody can tell";
  return text;
}

std::string text_of(const std::vector<report::RequirementRow>& rows) {
  const auto wanted = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.wanted; });
  const auto drawn =
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.wanted && row.is_drawn(); });
  return wanted == 0 ? "" : std::to_string(drawn) + " of " + std::to_string(wanted) + " are drawn";
}

// A line for each axis: "fidelity: 2 faults".
std::string axes_of(const report::Report& report) {
  std::string text;
  for (std::size_t i = 0; i < report::axis_names.size(); ++i) {
    const auto axis = static_cast<Axis>(i);
    const AxisCount count = count_on(axis, report.findings);
    std::string line = axis == Axis::completeness   ? text_of(report.sizes)
                       : axis == Axis::requirements ? text_of(report.requirements)
                                                    : "";
    if (count.faults > 0 || line.empty())
      append_to_list(line, count.faults == 0   ? "no fault"
                           : count.faults == 1 ? "1 fault"
                                               : std::to_string(count.faults) + " faults");
    if (count.accepted > 0) append_to_list(line, std::to_string(count.accepted) + " accepted");
    if (axis == Axis::fidelity && count.undecided > 0)
      append_to_list(line, std::to_string(count.undecided) + " not judged");
    text += axis_name(axis) + ": " + line + "\n";
  }
  return text;
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
std::string hint_of(const std::vector<std::string>& views, const std::string& transform) {
  if (!transform.empty())
    return "  hint: the part lies askew to the axes of the views: --transform '" + transform +
           "', after others, draws it along its own\n";
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
      text += std::string(finding.row().name) + ": " + std::to_string(count - max_alike) +
              " more that differ in numbers from: " + finding.what + " (--all lists them)\n";
  }
  return text;
}

}  // namespace

std::string findings_json(const report::Report& report) {
  const auto write = [](const report::Finding& finding) { return json_of(finding); };
  std::string axes;
  for (std::size_t axis = 0; axis < report::axis_names.size(); ++axis) {
    const AxisCount count = count_on(static_cast<Axis>(axis), report.findings);
    axes += (axes.empty() ? "" : ", ") + output::json_string(report::axis_names[axis]) +
            ": {\"faults\": " + std::to_string(count.faults) + ", \"accepted\": " + std::to_string(count.accepted) +
            ", \"undecided\": " + std::to_string(count.undecided) + "}";
  }
  return "{\"epura_lint\": 1, \"axes\": {" + axes +
         "}, \"findings\": " + output::json_lines(report.findings, write, "\n  ") +
         ", \"sizes\": " + output::json_list(report.sizes, [](const report::SizeCount& one) { return json_of(one); }) +
         ", \"requirements\": " +
         output::json_lines(
             report.requirements, [](const report::RequirementRow& row) { return json_of(row); }, "\n  ") +
         ", \"views_to_add\": " + output::json_list(report.views_to_add, output::json_string) +
         (report.transform_to_add.empty() ? ""
                                          : ", \"transform_to_add\": " + output::json_string(report.transform_to_add)) +
         "}\n";
}

int lint(DrawOptions options) {
  options.run.lint = true;
  options.run.hatch_free = !options.lint_picture.empty();
  if (options.run.hatch_free) {
    if (!options.outputs.empty())
      throw Error(ErrorKind::input, "--picture", "stands in the place of --output", "omit one of them");
    options.outputs = {options.lint_picture};
  }
  if (!options.found_json.empty()) pipeline::refuse_overwriting({options.found_json}, options.models);
  ProgressBoard board;
  Console console(board, shows_progress(options.progress), options.run.time_limit);
  const DrawnFiles drawn = draw_files(options, messages_to(console), Progress(board, options.run.time_limit));
  console.print("");
  tell_the_end(messages_to(console), options, drawn);
  const std::vector<report::Finding>& findings = drawn.report.findings;
  if (!options.found_json.empty()) pipeline::write({options.found_json, findings_json(drawn.report)}, {});
  if (options.found_json != "-") {
    std::fputs(printed_findings(findings, options.lint_all).c_str(), stdout);
    std::fputs(
        (hint_for_machines(drawn.report) + hint_of(drawn.report.views_to_add, drawn.report.transform_to_add)).c_str(),
        stdout);
    std::fputs(axes_of(drawn.report).c_str(), stdout);
  }
  const bool is_faulty = missing_in(drawn.report.sizes) > 0 ||
                         std::any_of(findings.begin(), findings.end(), [](const auto& one) { return one.is_fault(); });
  const int code = exit_code_of(drawn);
  return code == 0 && is_faulty ? found_wrong_exit_code : code;
}

}  // namespace epura
