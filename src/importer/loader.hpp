// SPDX-License-Identifier: Apache-2.0
// One library of importers, in the process that loads it: its tables, checked, and its answers.
#pragma once

#include <epura/importer_abi.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "foreign/parameters.hpp"
#include "importer/document.hpp"

namespace epura::importer {

/// What an importer says of itself.
struct ImporterTable {
  std::string name, summary;
  std::vector<std::string> extensions;  ///< lower case, without dots
  std::vector<foreign::Parameter> parameters;
  int has_mark = 0;  ///< whether it tells by their first bytes which files are its own
};

/// A file to be read; as epura_source says it.
struct Reading {
  std::string path;
  std::vector<double> values;
  double tolerance = 0, relative_tolerance = 0;  ///< 0: no bound
  int threads = 1;
};

struct LoadedImporter {
  ImporterTable table;
  const epura_importer* definition;
};

/// Opens the library. It is used whole or not at all: Error{plugin} says what is wrong with it, without its path.
/// Nothing where it is a library of projections.
std::vector<LoadedImporter> load_importers(const std::filesystem::path& library);

/// Throws Error{input} with what the importer says is wrong with the file, Error{plugin} where it contradicts itself.
Document read_by(const epura_importer& importer, const Reading& reading, const std::function<void(double)>& tell);

}  // namespace epura::importer
