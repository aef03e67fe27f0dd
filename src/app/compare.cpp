// SPDX-License-Identifier: Apache-2.0
// epura compare A B
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "compare/comparison.hpp"
#include "compare/html_report.hpp"
#include "compare/overlay.hpp"
#include "compare/report_pictures.hpp"
#include "pipeline/targets.hpp"

namespace epura {

namespace {

bool is_html(const std::string& path) {
  const std::string extension = to_lower(std::filesystem::path(path).extension().string());
  return extension == ".html" || extension == ".htm";
}

// Looked at before any work is done.
std::vector<Target> overlay_targets(const std::string& path) {
  if (path.empty() || is_html(path)) return {};
  std::vector<Target> targets = targets_of({path}, "");
  if (path == "-" || targets.front().format->has_drawings)
    throw Error(ErrorKind::input, "--overlay " + path, "is not a picture", "name an .svg, .png or .html file");
  return targets;
}

void write_overlay(const std::vector<Target>& targets, const Comparison& comparison) {
  if (targets.empty()) return;
  std::vector<FinishedSheet> sheets;
  for (const PageComparison& page : comparison.pages) sheets.push_back({overlay_of(page)});
  for (const FileBytes& file : encode_all(targets, sheets, {}, {}, {})) write(file, {});
}

}  // namespace

int compare(const CompareOptions& options) {
  const std::vector<Target> targets = overlay_targets(options.overlay);
  const PictureFile before = read_pictures(options.before), after = read_pictures(options.after);
  const Comparison comparison = compare(before, after, options.tolerance);
  const std::string words = format_comparison(comparison, options.tolerance);
  const bool same = comparison.differences.empty();
  std::vector<std::string> outputs = files_of(targets, comparison.pages.size());
  for (const std::string& file : {options.json, is_html(options.overlay) ? options.overlay : ""})
    if (!file.empty()) outputs.push_back(file);
  refuse_overwriting(outputs, {options.before, options.after});
  write_overlay(targets, comparison);
  if (is_html(options.overlay))
    write_file(options.overlay, html_report(options.before + " | " + options.after,
                                            {add_pictures({options.after, same, words}, before, after, comparison)}));
  if (!options.json.empty())
    write({options.json, to_json(comparison, options.tolerance, options.before, options.after)}, {});
  if (options.json != "-") std::fputs(words.c_str(), stdout);
  return same ? 0 : 1;
}

}  // namespace epura
