// SPDX-License-Identifier: Apache-2.0
#include "snapshot/cases.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <system_error>

#include "app/run_epura.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/folder.hpp"
#include "compare/comparison.hpp"
#include "snapshot/case_files.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

bool is_case(const fs::path& folder) { return fs::is_regular_file(folder / "scene.toml"); }

// Adds the cases in folder / below. Links to folders may be cases, but are not followed: they may lead in a circle.
void add_cases_below(const fs::path& folder, const fs::path& root, const fs::path& below,
                     std::vector<SnapshotCase>& cases) {
  for (const std::string& name : names_in(folder / below)) {
    const fs::path inner = below / name, path = folder / inner;
    if (!fs::is_directory(path)) continue;
    if (is_case(path)) cases.push_back({inner.generic_string(), path, root});
    if (!fs::is_symlink(path)) add_cases_below(folder, root, inner, cases);
  }
}

std::vector<fs::path> expectations(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* name : {"expected.json", "expected.svg", "expected.pdf"})
    if (fs::exists(folder / name)) files.push_back(folder / name);
  return files;
}

// Returns whether the case was drawn.
bool draw_case(const SnapshotCase& one, const std::vector<fs::path>& plugin_path, SnapshotResult& result) {
  refuse_links_outside(one);
  std::vector<std::string> arguments{"draw", "--allow-outside", (one.folder / "scene.toml").string()};
  const fs::path options = one.folder / "options";
  if (fs::exists(options)) {
    const std::vector<std::string> words = drawing_options(read_file(options), options.string());
    refuse_options_outside(words, one);
    arguments.insert(arguments.end(), words.begin(), words.end());
  }
  for (const fs::path& folder : plugin_path) arguments.insert(arguments.end(), {"--plugin-path", folder.string()});
  const std::string format = result.expected.extension().string().substr(1);
  arguments.insert(arguments.end(), {"--output", "-", "--format", format, "--progress", "never"});
  ProgramRun run = run_epura(arguments);
  result.actual = std::move(run.out);
  if (run.code != 0) result.words = "exit code " + std::to_string(run.code) + "\n" + run.err;
  return run.code == 0;
}

void compare_with_expectation(SnapshotResult& result, double tolerance, bool with_pictures) {
  const compare::PictureFile actual = compare::pictures_of(result.actual, result.expected);
  const bool exists = fs::exists(result.expected) && fs::file_size(result.expected) > 0;
  const compare::PictureFile expected =
      exists ? compare::read_pictures(result.expected) : compare::PictureFile{actual.is_json, actual.is_pdf, {}};
  const compare::Comparison comparison = compare::compare(expected, actual, tolerance);
  const bool same = comparison.differences.empty();
  result.verdict = !exists ? SnapshotVerdict::new_case
                   : same  ? SnapshotVerdict::as_expected
                           : SnapshotVerdict::different;
  result.words = exists ? compare::format_comparison(comparison, tolerance) : "no expected drawing yet\n";
  if (with_pictures && result.verdict != SnapshotVerdict::as_expected)
    result.pictures = compare::add_pictures({result.name, false, result.words}, expected, actual, comparison);
}

// Other files may be endless, or block.
void refuse_irregular_files(const fs::path& folder) {
  constexpr std::uintmax_t max_option_bytes = 1'000'000;
  for (const char* name : {"options", "expected.json", "expected.svg", "expected.pdf"})
    if (fs::exists(folder / name) && !fs::is_regular_file(folder / name))
      throw Error(ErrorKind::input, (folder / name).string(), "is not a regular file");
  if (fs::exists(folder / "options") && fs::file_size(folder / "options") > max_option_bytes)
    throw Error(ErrorKind::input, (folder / "options").string(), "has more than 1 MB", "is it the right file?");
}

}  // namespace

std::vector<SnapshotCase> find_cases(const std::vector<std::string>& folders) {
  std::vector<SnapshotCase> cases;
  for (const std::string& name : folders) {
    const fs::path folder = fs::path(name).lexically_normal();
    std::error_code unreadable;  // such as a name that is too long
    if (!fs::is_directory(folder, unreadable)) throw Error(ErrorKind::input, name, "is not a folder");
    const fs::path root = fs::canonical(folder);
    const std::size_t before = cases.size();
    const bool ends_in_slash = folder.filename().empty();
    if (is_case(folder))
      cases.push_back({(ends_in_slash ? folder.parent_path() : folder).filename().string(), folder, root});
    add_cases_below(folder, root, {}, cases);
    if (cases.size() == before)
      throw Error(ErrorKind::input, name, "contains no case",
                  "a case is a folder with scene.toml, and expected.svg or another expected drawing");
    std::sort(cases.begin() + static_cast<std::ptrdiff_t>(before), cases.end(),
              [](const SnapshotCase& a, const SnapshotCase& b) { return a.name < b.name; });
  }
  return cases;
}

std::vector<SnapshotResult> run_case(const SnapshotCase& one, const SnapshotOptions& options) {
  std::vector<fs::path> files = expectations(one.folder);
  if (files.empty()) files.push_back(one.folder / "expected.svg");
  std::vector<SnapshotResult> results;
  for (const fs::path& file : files) {
    SnapshotResult& result = results.emplace_back();
    result.name = one.name + "/" + file.filename().string();
    result.expected = file;
    try {
      refuse_irregular_files(one.folder);
      if (draw_case(one, options.plugin_path, result))
        compare_with_expectation(result, options.tolerance, !options.report.empty());
    } catch (const Error& error) {
      result.words = std::string(error.what()) + "\n" + (error.hint().empty() ? "" : "hint: " + error.hint() + "\n");
    }
    if (result.pictures.name.empty())
      result.pictures = {result.name, result.verdict == SnapshotVerdict::as_expected, result.words};
  }
  return results;
}

}  // namespace epura
