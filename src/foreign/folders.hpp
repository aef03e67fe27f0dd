// SPDX-License-Identifier: Apache-2.0
// Where plugins lie.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace epura::foreign {

/// A library or a folder that could not be used, and why.
struct BadPlugin {
  std::filesystem::path path;
  std::string reason;
};

/// Where plugins are looked for, first wins: `extra`, then $EPURA_PLUGIN_PATH (folders with colons between), then the
/// folder `own` of what came with this program. Never the current folder unless it is named.
std::vector<std::filesystem::path> plugin_folders(const std::vector<std::filesystem::path>& extra,
                                                  const std::string& own);

/// The libraries (*.so) of a folder in order of their names, since the order in which a folder lists them is
/// accidental.
std::vector<std::filesystem::path> libraries_in(const std::filesystem::path& folder, std::vector<BadPlugin>& bad);

}  // namespace epura::foreign
