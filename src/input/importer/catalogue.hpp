// SPDX-License-Identifier: Apache-2.0
// Lists the available importers.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "foreign/folders.hpp"
#include "importer/process.hpp"

namespace epura::importer {

struct Catalogue {
  std::vector<ImporterEntry> entries;  ///< of several with one name, the first one found
  std::vector<foreign::BadPlugin> bad;
};

/// Returns the formats that are read without a library: meshes.
std::vector<ImporterTable> built_in_importers();

/// Returns `extra` and $EPURA_PLUGIN_PATH, which may contain projections as well, and the folder importers/ installed
/// with this program.
std::vector<std::filesystem::path> importer_folders(const std::vector<std::filesystem::path>& extra);

/// Loads every library in the folders, each in its own process.
Catalogue load_catalogue(const std::vector<std::filesystem::path>& folders);

/// Returns the Debian package that reads files with an extension; empty if there is none.
std::string_view package_for(std::string_view extension);

}  // namespace epura::importer
