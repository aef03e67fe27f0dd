// SPDX-License-Identifier: Apache-2.0
// One library of importers, in the process that loads it: its checked tables and its answers.
#pragma once

#include <epura/importer_abi.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "foreign/parameters.hpp"
#include "importer/bounds.hpp"
#include "importer/imported_file.hpp"

namespace epura::importer {

/// The description of an importer by its library.
struct ImporterTable {
  std::string name, summary;
  std::vector<std::string> extensions;  ///< lower case, without dots
  std::vector<foreign::Parameter> parameters;
  int has_mark = 0;  ///< whether it can recognise files by their first bytes
};

/// A file to read; the fields correspond to epura_source.
struct Reading {
  std::filesystem::path path;
  std::string name;                              ///< by which errors call it
  std::vector<double> values;                    ///< those of `parameters_of_bounds` are the last
  double tolerance = 0, relative_tolerance = 0;  ///< 0: no bound
  int threads = 1;
  int may_leave = 0;    ///< the file may refer to files outside its folder
  int is_confined = 0;  ///< the process opens no other files any more
  Bounds bounds{};      ///< of the process
  /// What it opens if it is confined; nothing if the path leads to a file in memory.
  std::vector<std::filesystem::path> readable{};
};

struct LoadedImporter {
  ImporterTable table;
  const epura_importer* definition;
};

/// Opens the library. If any of its importers is invalid, throws Error{plugin} with the reason, without the path.
/// Returns nothing for a library of projections.
std::vector<LoadedImporter> load_importers(const std::filesystem::path& library);

/// The same of what a library returns, which must remain as long as the importers. May be null.
std::vector<LoadedImporter> read_list(const epura_importer_list* list);

/// Throws Error{input} with the importer's message if the file is invalid, and Error{plugin} if the importer violates
/// the interface.
ImportedFile read_by(const epura_importer& importer, const Reading& reading, const std::function<void(double)>& tell);

}  // namespace epura::importer
