// SPDX-License-Identifier: Apache-2.0
#include "snapshot/snapshot.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "app/junit.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "pipeline/targets.hpp"
#include "snapshot/case_files.hpp"
#include "snapshot/cases.hpp"

namespace epura {

namespace {

std::vector<SnapshotResult> run_all(const std::vector<SnapshotCase>& cases, const SnapshotOptions& options) {
  std::vector<std::vector<SnapshotResult>> found(cases.size());
  parallel_for(cases.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = run_case(cases[i], options);
  });
  std::vector<SnapshotResult> results;
  for (std::vector<SnapshotResult>& of_case : found)
    for (SnapshotResult& result : of_case) results.push_back(std::move(result));
  return results;
}

// The report contains the rest.
std::string first_lines(const std::string& text) {
  constexpr std::size_t max = 10;
  const std::vector<std::string_view> lines = split(text, '\n');
  std::string indented;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    if (i == max && lines.size() > max + 2) indented.append("  ...\n");
    if (i < max || i + 2 >= lines.size()) indented.append("  ").append(lines[i]).append("\n");
  }
  return indented;
}

const char* name_of(SnapshotVerdict verdict, bool accepted) {
  if (accepted) return "accepted ";
  switch (verdict) {
    case SnapshotVerdict::as_expected:
      return "ok       ";
    case SnapshotVerdict::different:
      return "DIFFERENT";
    case SnapshotVerdict::new_case:
      return "NEW      ";
    case SnapshotVerdict::failed:
      return "FAILED   ";
  }
  return "";
}

std::vector<std::string> outputs_of(const SnapshotOptions& options) {
  std::vector<std::string> files;
  for (const std::string& file : {options.report, options.junit})
    if (!file.empty()) files.push_back(file);
  return files;
}

std::vector<std::string> inputs_of(const std::vector<SnapshotCase>& cases) {
  std::vector<std::string> inputs;
  for (const SnapshotCase& one : cases) {
    try {
      for (const std::filesystem::path& file : files_of(one)) inputs.push_back(file.string());
    } catch (const Error&) {
      inputs.push_back((one.folder / "scene.toml").string());  // if it is not a scene, the result says so
    }
  }
  return inputs;
}

bool can_be_accepted(const SnapshotResult& result) {
  return result.verdict == SnapshotVerdict::different || result.verdict == SnapshotVerdict::new_case;
}

std::vector<TestCase> cases_of(const std::vector<SnapshotResult>& results) {
  std::vector<TestCase> cases;
  for (const SnapshotResult& result : results) {
    const TestVerdict verdict = result.verdict == SnapshotVerdict::as_expected ? TestVerdict::passed
                                : result.verdict == SnapshotVerdict::failed    ? TestVerdict::error
                                                                               : TestVerdict::failure;
    cases.push_back({result.name, verdict, result.words});
  }
  return cases;
}

}  // namespace

int snapshot(const SnapshotOptions& options) {
  if (options.accept && std::getenv("CI") != nullptr)
    throw Error(ErrorKind::input, "--accept",
                "expected drawings must be accepted by a person, but CI is set in the environment",
                "run it where you can view the report, and commit what it writes");
  const std::vector<SnapshotCase> cases = find_cases(options.folders);
  pipeline::refuse_overwriting(outputs_of(options), inputs_of(cases));
  const ThreadLimit threads(options.threads);
  const std::vector<SnapshotResult> results = run_all(cases, options);
  std::size_t good = 0;
  std::string text;
  std::vector<compare::ReportedCase> pictures;
  for (const SnapshotResult& result : results) {
    const bool accepted = options.accept && can_be_accepted(result);
    if (accepted) write_file(result.expected, result.actual);
    if (accepted || result.verdict == SnapshotVerdict::as_expected) ++good;
    text += std::string(name_of(result.verdict, accepted)) + " " + result.name + "\n";
    if (result.verdict != SnapshotVerdict::as_expected) text += first_lines(result.words);
    pictures.push_back(result.pictures);
  }
  if (!options.report.empty()) write_file(options.report, compare::html_report("epura snapshot", pictures));
  if (!options.junit.empty())
    write_file(options.junit, junit_report("epura snapshot", "epura.snapshot", cases_of(results)));
  text += std::to_string(good) + " of " + std::to_string(results.size()) + " as expected\n";
  std::fputs(printable(text).c_str(), stdout);
  return good == results.size() ? 0 : 1;
}

}  // namespace epura
