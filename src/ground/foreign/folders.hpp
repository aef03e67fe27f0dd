// SPDX-License-Identifier: Apache-2.0
// Finds folders and libraries of plugins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace epura::foreign {

/// A library or folder that could not be used, and the reason.
struct BadPlugin {
  std::filesystem::path path;
  std::string reason;
};

/// Returns the folders in which plugins are searched for, in order of precedence: `extra`, then $EPURA_PLUGIN_PATH
/// (absolute paths of folders, separated by colons), then the folder `own` of those that came with this program. Never
/// contains the current folder unless `extra` names it. Throws Error{plugin} for relative paths in the variable, and
/// for folders before `own` that everyone can write to, or in which everyone can change a library.
std::vector<std::filesystem::path> plugin_folders(const std::vector<std::filesystem::path>& extra,
                                                  const std::string& own);

/// Returns the libraries (*.so) of a folder, sorted by name.
std::vector<std::filesystem::path> libraries_in(const std::filesystem::path& folder, std::vector<BadPlugin>& bad);

}  // namespace epura::foreign
