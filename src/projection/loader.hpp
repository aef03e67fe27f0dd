// SPDX-License-Identifier: Apache-2.0
// One plugin: opens the library in this process, checks everything it says, and copies its tables.
#pragma once

#include <filesystem>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// What the library offers. A library is used whole or not at all: Error{plugin} says what is wrong with it, without
/// its path. Nothing of a library of importers.
std::vector<ProjectionEntry> read_plugin(const std::filesystem::path& path);

}  // namespace epura::projection
