// SPDX-License-Identifier: Apache-2.0
// Importers that are made for tests, and files for them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "errors.hpp"
#include "folder.hpp"
#include "importer/read_model.hpp"

namespace epura::test {

inline std::filesystem::path folder_of(const std::string& importer) {
  return std::filesystem::path(EPURA_TEST_BAD_PLUGINS) / "importers" / importer;
}

inline importer::ReadModel read_by(const std::string& importer, const std::filesystem::path& file,
                                   const foreign::Assignments& parameters = {}) {
  return importer::read_model(file, parameters, {.plugin_path = {folder_of(importer)}});
}

}  // namespace epura::test
