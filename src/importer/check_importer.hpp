// SPDX-License-Identifier: Apache-2.0
// Tests of an importer that know nothing but its table: for authors of importers, and for the ones built here.
#pragma once

#include <filesystem>
#include <vector>

#include "foreign/check_result.hpp"
#include "importer/process.hpp"

namespace epura::importer {

/// The checks in a fixed order. `models` are files; from each that has an extension of the importer, damaged ones are
/// made in a folder of temporary files. An answer may take `seconds`.
std::vector<foreign::CheckResult> check_importer(const ImporterEntry& importer,
                                                 const std::vector<std::filesystem::path>& models, double seconds,
                                                 const foreign::TellResult& tell = {});

}  // namespace epura::importer
