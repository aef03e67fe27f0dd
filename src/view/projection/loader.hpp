// SPDX-License-Identifier: Apache-2.0
// One plugin: opens the library in this process, checks everything in it, and copies its tables.
#pragma once

#include <epura/projection_abi.h>

#include <filesystem>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// Returns the projections in the library, or nothing for a library of importers. A library is used as a whole or not
/// at all: Error{plugin} says what is wrong with it, without its path.
std::vector<ProjectionEntry> read_plugin(const std::filesystem::path& path);

/// The same of what a library returns, which must remain as long as the entries. May be null.
std::vector<ProjectionEntry> read_list(const epura_projection_list* list, const std::filesystem::path& path);

}  // namespace epura::projection
