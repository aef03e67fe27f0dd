// SPDX-License-Identifier: Apache-2.0
#include "importer/loader.hpp"

#include <epura/projection_abi.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "base/text.hpp"
#include "importer/sink.hpp"

namespace epura::importer {

namespace {

using foreign::require;

std::vector<std::string> extensions_of(const char* text, const std::string& owner) {
  require(text != nullptr, owner + " has no extensions");
  std::vector<std::string> extensions;
  for (const std::string_view extension : split(text, '|')) {
    require(foreign::is_plugin_name(extension),
            owner + " has an extension that is not lower case, digits and '-' with '|' between");
    extensions.emplace_back(extension);
  }
  return extensions;
}

ImporterTable table_of(const epura_importer& row, std::size_t place) {
  const std::string nth = "importer " + std::to_string(place + 1);
  require(row.name != nullptr, nth + " has no name");
  require(foreign::is_plugin_name(row.name), nth + ": the name '" + row.name + "' is not lower case, digits and '-'");
  const std::string owner = std::string("importer '") + row.name + "'";
  require(row.summary != nullptr, owner + " has no summary");
  require(row.read != nullptr, owner + " has no function");
  return {.name = row.name,
          .summary = row.summary,
          .extensions = extensions_of(row.extensions, owner),
          .parameters = foreign::read_parameters(row.parameters, row.parameter_count, owner),
          .has_mark = row.recognises != nullptr ? 1 : 0};
}

void expect_sound(const epura_importer_list* list) {
  require(list != nullptr, EPURA_IMPORTER_ENTRY_POINT " returns nothing");
  require(list->abi == EPURA_IMPORTER_ABI_VERSION, "is built for importer ABI " + std::to_string(list->abi) +
                                                       ", this program has " +
                                                       std::to_string(EPURA_IMPORTER_ABI_VERSION));
  require(list->size >= sizeof(epura_importer_list), "its list is too short: " + std::to_string(list->size) + " of " +
                                                         std::to_string(sizeof(epura_importer_list)) + " bytes");
  require(list->count > 0 && list->importers != nullptr, "offers no importer");
  require(list->count <= foreign::max_rows, "claims to provide " + std::to_string(list->count) + " importers");
}

}  // namespace

std::vector<LoadedImporter> load_importers(const std::filesystem::path& library) {
  void* handle = load_library(library, ErrorKind::plugin);
  void* symbol = find_symbol(handle, EPURA_IMPORTER_ENTRY_POINT);
  if (symbol == nullptr && find_symbol(handle, EPURA_ENTRY_POINT) != nullptr) return {};
  require(symbol != nullptr, "is not a library of importers: it has no function " EPURA_IMPORTER_ENTRY_POINT);
  return read_list(reinterpret_cast<epura_importer_entry_point>(symbol)());
}

std::vector<LoadedImporter> read_list(const epura_importer_list* list) {
  expect_sound(list);
  std::vector<LoadedImporter> importers;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->count; ++i) {
    const epura_importer& row = foreign::row_of(list->importers, i, "its list");
    importers.push_back({table_of(row, i), &row});
    require(names.insert(row.name).second, std::string("offers two importers '") + row.name + "'");
  }
  return importers;
}

ImportedFile read_by(const epura_importer& importer, const Reading& reading, const std::function<void(double)>& tell) {
  const epura_source source{sizeof(epura_source),
                            static_cast<uint32_t>(std::max(reading.threads, 1)),
                            reading.path.c_str(),
                            reading.values.data(),
                            reading.tolerance,
                            reading.relative_tolerance,
                            static_cast<uint32_t>(reading.may_leave),
                            0};
  DocumentSink sink(tell);
  const char* sentence = nullptr;
  try {
    sentence = importer.read(&source, &sink.calls());
  } catch (...) {
    throw Error(ErrorKind::plugin, "", "threw an exception across the C interface");
  }
  if (!sink.fault().empty()) throw Error(ErrorKind::plugin, "", sink.fault());
  if (sentence != nullptr) throw Error(ErrorKind::input, "", sentence);
  return std::move(sink.document());
}

}  // namespace epura::importer
