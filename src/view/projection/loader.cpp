// SPDX-License-Identifier: Apache-2.0
#include "projection/loader.hpp"

#include <epura/importer_abi.h>
#include <epura/projection_abi.h>

#include <set>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "foreign/parameters.hpp"
#include "projection/answer.hpp"

namespace epura::projection {

namespace {

using foreign::max_rows;
using foreign::require;
using foreign::row_of;

std::string number(std::size_t n) { return std::to_string(n); }

void expect_sound(const epura_projection_list* list) {
  require(list != nullptr, EPURA_ENTRY_POINT " returns nothing");
  require(list->abi == EPURA_ABI_VERSION,
          "is built for plugin ABI " + number(list->abi) + ", this program has " + number(EPURA_ABI_VERSION));
  require(list->size >= sizeof(epura_projection_list),
          "its list is too short: " + number(list->size) + " of " + number(sizeof(epura_projection_list)) + " bytes");
  require(list->count > 0 && list->projections != nullptr, "provides no projection");
  require(list->count <= max_rows, "claims to provide " + number(list->count) + " projections");
}

ProjectionEntry entry_of(const epura_projection& row, std::size_t place, const std::filesystem::path& path) {
  const std::string nth = "projection " + number(place + 1);
  require(row.name != nullptr, nth + " has no name");
  require(foreign::is_plugin_name(row.name), nth + ": the name '" + row.name + "' is not lower case, digits and '-'");
  const std::string projection = std::string("projection '") + row.name + "'";
  require(row.family != nullptr && row.summary != nullptr, projection + " has no family or no summary");
  require(row.project != nullptr, projection + " has no function");
  return {
      .name = row.name,
      .family = row.family,
      .summary = row.summary,
      .reference = row.reference == nullptr ? "" : row.reference,
      .parameters = foreign::read_parameters(row.parameters, row.parameter_count, projection),
      .plugin = path,
      .ask = [&row](const std::vector<double>& values, const Box& scene) { return call_plugin(row, values, scene); }};
}

}  // namespace

std::vector<ProjectionEntry> read_plugin(const std::filesystem::path& path) {
  void* library = load_library(path, ErrorKind::plugin);
  void* symbol = find_symbol(library, EPURA_ENTRY_POINT);
  if (symbol == nullptr && find_symbol(library, EPURA_IMPORTER_ENTRY_POINT) != nullptr) return {};
  require(symbol != nullptr, "is not a projection plugin: it has no function " EPURA_ENTRY_POINT);
  return read_list(reinterpret_cast<epura_entry_point>(symbol)(), path);
}

std::vector<ProjectionEntry> read_list(const epura_projection_list* list, const std::filesystem::path& path) {
  expect_sound(list);
  std::vector<ProjectionEntry> entries;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->count; ++i) {
    entries.push_back(entry_of(row_of(list->projections, i, "its list"), i, path));
    require(names.insert(entries.back().name).second, "provides two projections '" + entries.back().name + "'");
  }
  return entries;
}

}  // namespace epura::projection
