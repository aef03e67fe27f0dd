// SPDX-License-Identifier: Apache-2.0
// The models of a batch: files, patterns, folders and lists.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace epura {

struct FoundModels {
  std::vector<std::string> models;
  std::vector<std::string> passed_over;  ///< in folders, since their names begin with a dot
};

/// Returns the models in the order of `sources`, those of a folder or pattern sorted by path. A source is a file (also
/// with parameters of its importer), a folder, which stands for all models below it, a pattern with `*`, `?`, `[...]`
/// and `**` for any folders, or `-` for a list on standard input: a path a line, or separated by zeros. Files and
/// folders whose names begin with a dot are passed over. Throws Error{input} for a source without any model.
/// `plugin_path` are more folders with importers, whose extensions count in folders.
FoundModels models_of_sources(const std::vector<std::string>& sources,
                              const std::vector<std::filesystem::path>& plugin_path);

/// Whether a path fits a pattern; `**` as a whole part of it stands for any number of folders.
bool fits_pattern(const std::filesystem::path& path, const std::filesystem::path& pattern);

}  // namespace epura
