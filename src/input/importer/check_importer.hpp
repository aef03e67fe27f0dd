// SPDX-License-Identifier: Apache-2.0
// Tests an importer by its table alone: for authors of importers, and for the importers of this project.
#pragma once

#include <filesystem>
#include <vector>

#include "foreign/check_result.hpp"
#include "importer/process.hpp"

namespace epura::importer {

/// Runs the checks in a fixed order. `models` are files; each one with an extension of the importer is also tested in
/// damaged versions, which are written to a temporary folder. Each answer may take `seconds`.
std::vector<foreign::CheckResult> check_importer(const ImporterEntry& importer,
                                                 const std::vector<std::filesystem::path>& models, double seconds,
                                                 const foreign::TellResult& tell = {});

}  // namespace epura::importer
