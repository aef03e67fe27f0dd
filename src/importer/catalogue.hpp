// SPDX-License-Identifier: Apache-2.0
// Which importers there are.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "foreign/folders.hpp"
#include "importer/process.hpp"

namespace epura::importer {

struct Catalogue {
  std::vector<ImporterEntry> entries;  ///< of one name the first that was found
  std::vector<foreign::BadPlugin> bad;
};

/// What is read without a library: meshes.
std::vector<ImporterTable> built_in_importers();

/// `extra` and $EPURA_PLUGIN_PATH may hold projections, too; then importers/ of what came with this program.
std::vector<std::filesystem::path> importer_folders(const std::vector<std::filesystem::path>& extra);

/// Loads every library in the folders, each in a process of its own.
Catalogue load_catalogue(const std::vector<std::filesystem::path>& folders);

/// The Debian package that reads files with an extension; empty where there is none.
std::string_view package_for(std::string_view extension);

}  // namespace epura::importer
