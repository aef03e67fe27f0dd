// SPDX-License-Identifier: Apache-2.0
#include "app/jobs/sources.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <iterator>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "importer/catalogue.hpp"
#include "importer/read_model.hpp"

namespace epura {

namespace fs = std::filesystem;

namespace {

bool is_pattern(std::string_view text) { return text.find_first_of("*?[") != std::string_view::npos; }

using Wanted = std::function<bool(const fs::path&)>;

// Folders that may not be read are passed over, and links to folders are not followed: they may lead in a circle.
void add_files_below(const fs::path& folder, const Wanted& is_wanted, FoundModels& files) {
  std::error_code failure, unreadable;
  for (const std::string& name : names_in(folder.empty() ? "." : folder, failure)) {
    const fs::path path = folder / name;
    const bool is_passed_over = name.starts_with('.');
    if (fs::is_directory(fs::symlink_status(path, unreadable))) {
      if (!is_passed_over) add_files_below(path, is_wanted, files);
    } else if (is_wanted(path) && fs::is_regular_file(path, unreadable)) {
      (is_passed_over ? files.passed_over : files.models).push_back(path.string());
    }
  }
  if (failure && failure != std::errc::permission_denied)
    throw Error(ErrorKind::input, folder.string(), "cannot be listed: " + failure.message());
}

// Returns the files below a folder, in which an empty path stands for the current one, that are wanted.
FoundModels files_below(const fs::path& folder, const Wanted& is_wanted) {
  FoundModels files;
  add_files_below(folder, is_wanted, files);
  std::sort(files.models.begin(), files.models.end());
  std::sort(files.passed_over.begin(), files.passed_over.end());
  return files;
}

FoundModels files_of_pattern(const fs::path& pattern) {
  fs::path folder;
  for (const fs::path& part : pattern.parent_path()) {
    if (is_pattern(part.string())) break;
    folder /= part;
  }
  std::error_code ignored;
  if (!folder.empty() && !fs::is_directory(folder, ignored)) return {};
  return files_below(folder, [&](const fs::path& path) { return fits_pattern(path, pattern); });
}

// The extensions of models, without dots. Loads the importers.
std::set<std::string> model_extensions(const std::vector<fs::path>& plugin_path) {
  std::set<std::string> extensions;
  for (const importer::ImporterTable& table : importer::built_in_importers())
    extensions.insert(table.extensions.begin(), table.extensions.end());
  for (const importer::ImporterEntry& entry : importer::load_catalogue(importer::importer_folders(plugin_path)).entries)
    extensions.insert(entry.table.extensions.begin(), entry.table.extensions.end());
  return extensions;
}

FoundModels models_below(const fs::path& folder, const std::set<std::string>& extensions) {
  return files_below(folder, [&](const fs::path& path) {
    const std::string extension = to_lower(path.extension().string());
    return !extension.empty() && extensions.count(extension.substr(1)) > 0;
  });
}

std::vector<std::string> listed_on_standard_input() {
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const char separator = text.find('\0') != std::string::npos ? '\0' : '\n';
  std::vector<std::string> models;
  for (std::string_view line : split(text, separator)) {
    if (separator == '\n' && line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty()) models.emplace_back(line);
  }
  return models;
}

bool fits(fs::path::iterator path, const fs::path::iterator& path_end, fs::path::iterator pattern,
          const fs::path::iterator& pattern_end) {
  if (pattern == pattern_end) return path == path_end;
  if (*pattern == "**") {
    const auto rest = std::next(pattern);
    for (;; ++path) {
      if (fits(path, path_end, rest, pattern_end)) return true;
      if (path == path_end) return false;
    }
  }
  return path != path_end && ::fnmatch(pattern->c_str(), path->c_str(), FNM_PERIOD) == 0 &&
         fits(std::next(path), path_end, std::next(pattern), pattern_end);
}

}  // namespace

bool fits_pattern(const fs::path& path, const fs::path& pattern) {
  return fits(path.begin(), path.end(), pattern.begin(), pattern.end());
}

FoundModels models_of_sources(const std::vector<std::string>& sources, const std::vector<fs::path>& plugin_path) {
  FoundModels all;
  std::set<std::string> extensions;
  for (const std::string& source : sources) {
    std::error_code ignored;
    FoundModels found;
    std::string without = "no file fits this pattern";
    if (source == importer::standard_input) {
      found.models = listed_on_standard_input();
      without = "the list on standard input is empty";
    } else if (fs::is_directory(source, ignored)) {
      if (extensions.empty()) extensions = model_extensions(plugin_path);
      found = models_below(source, extensions);
      without = "there is no model in this folder";
    } else if (is_pattern(source) && !fs::exists(importer::parse_model_request(source).path, ignored)) {
      found = files_of_pattern(source);
    } else {
      found.models = {source};
    }
    if (found.models.empty())
      throw Error(ErrorKind::input, source, without, "'epura importers' lists the files that are read");
    all.models.insert(all.models.end(), found.models.begin(), found.models.end());
    all.passed_over.insert(all.passed_over.end(), found.passed_over.begin(), found.passed_over.end());
  }
  return all;
}

}  // namespace epura
