// SPDX-License-Identifier: Apache-2.0
#include "snapshot/compare.hpp"

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
#include "pipeline/targets.hpp"
#include "snapshot/compared_files.hpp"

namespace epura {

namespace {

bool is_html(const std::string& path) {
  const std::string extension = to_lower(std::filesystem::path(path).extension().string());
  return extension == ".html" || extension == ".htm";
}

// Checked before any work is done.
std::vector<pipeline::Target> overlay_targets(const std::string& path) {
  if (path.empty() || is_html(path)) return {};
  std::vector<pipeline::Target> targets = pipeline::targets_of({path}, "");
  if (path == "-" || targets.front().format->has_drawings)
    throw Error(ErrorKind::input, "--overlay " + path, "is not a picture", "name an .svg, .png or .html file");
  return targets;
}

void write_overlay(const std::vector<pipeline::Target>& targets, const compare::Comparison& comparison) {
  if (targets.empty()) return;
  std::vector<pipeline::FinishedSheet> sheets;
  for (const compare::PageComparison& page : comparison.pages) sheets.push_back({compare::overlay_of(page)});
  for (const pipeline::FileBytes& file : pipeline::encode_all(targets, sheets, {}, {}, {})) pipeline::write(file, {});
}

}  // namespace

int compare_files(const CompareOptions& options) {
  const std::vector<pipeline::Target> targets = overlay_targets(options.overlay);
  const auto [before, after] = pictures_to_compare(options);
  const compare::Comparison comparison = compare::compare(before, after, options.tolerance);
  const std::string words = compare::format_comparison(comparison, options.tolerance);
  const bool same = comparison.is_same();
  std::vector<std::string> outputs = pipeline::files_of(targets, comparison.pages.size());
  for (const std::string& file : {options.json, options.markdown, is_html(options.overlay) ? options.overlay : ""})
    if (!file.empty()) outputs.push_back(file);
  pipeline::refuse_overwriting(outputs, {options.before, options.after});
  write_overlay(targets, comparison);
  if (is_html(options.overlay))
    write_file(options.overlay,
               compare::overlay_page(options.before + " | " + options.after, words, before, after, comparison));
  if (!options.json.empty())
    pipeline::write({options.json, compare::to_json(comparison, options.tolerance, options.before, options.after)}, {});
  if (!options.markdown.empty())
    pipeline::write(
        {options.markdown, compare::to_markdown(comparison, options.tolerance, options.before, options.after)}, {});
  if (options.json != "-" && options.markdown != "-") std::fputs(words.c_str(), stdout);
  return same ? 0 : 1;
}

}  // namespace epura
