// SPDX-License-Identifier: Apache-2.0
#include "projection/loader.hpp"

#include <epura/projection_abi.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "base/error.hpp"
#include "base/shared_library.hpp"
#include "base/text.hpp"
#include "projection/answer.hpp"

namespace epura::projection {

namespace {

// More is a sign of memory that was never filled in.
constexpr uint32_t most_rows = 1000;

[[noreturn]] void refuse(const std::string& reason) { throw Error(ErrorKind::plugin, "", reason); }

void require(bool condition, const std::string& reason) {
  if (!condition) refuse(reason);
}

std::string number(std::size_t n) { return std::to_string(n); }

epura_entry_point entry_point(const std::filesystem::path& path) {
  void* symbol = find_symbol(load_library(path, ErrorKind::plugin), EPURA_ENTRY_POINT);
  require(symbol != nullptr, "is not a projection plugin: it has no function " EPURA_ENTRY_POINT);
  return reinterpret_cast<epura_entry_point>(symbol);
}

const epura_projection_list& list_of(epura_entry_point entry) {
  const epura_projection_list* list = entry();
  require(list != nullptr, EPURA_ENTRY_POINT " returns nothing");
  require(list->abi == EPURA_ABI_VERSION,
          "is built for plugin ABI " + number(list->abi) + ", this program has " + number(EPURA_ABI_VERSION));
  require(list->size >= sizeof(epura_projection_list),
          "its list is too short: " + number(list->size) + " of " + number(sizeof(epura_projection_list)) + " bytes");
  require(list->count > 0 && list->projections != nullptr, "offers no projection");
  require(list->count <= most_rows, "claims to offer " + number(list->count) + " projections");
  return *list;
}

/// Row `i` of a table whose rows are as long as its first one says: a newer plugin has longer rows than this program.
template <class Row>
const Row& row_of(const Row* first, std::size_t i, const std::string& whose) {
  require(first->size >= sizeof(Row) && first->size % alignof(Row) == 0,
          whose + " has rows of " + number(first->size) + " bytes, at least " + number(sizeof(Row)) + " are needed");
  const auto* bytes = reinterpret_cast<const std::byte*>(first) + i * first->size;
  const Row& row = *reinterpret_cast<const Row*>(bytes);
  require(row.size == first->size, whose + " has rows of different sizes");
  return row;
}

std::vector<std::string> choices_of(const epura_parameter& row, const std::string& where) {
  if (row.type != EPURA_CHOICE) return {};
  require(row.choices != nullptr, where + " has no choices");
  std::vector<std::string> choices;
  for (const std::string_view choice : split(row.choices, '|')) {
    require(!choice.empty(), where + " has an empty choice");
    choices.emplace_back(choice);
  }
  return choices;
}

void check_initial(const Parameter& parameter, const std::string& where) {
  require(parameter.min <= parameter.max, where + " has no range");
  const bool is_choice = parameter.type == ParameterType::choice;
  const double last = static_cast<double>(parameter.choices.size()) - 1;
  for (const double value : parameter.initial) {
    const bool fits = is_choice ? value >= 0 && value <= last && value == std::floor(value)
                                : std::isnan(value) || (value >= parameter.min && value <= parameter.max);
    require(fits, where + " has a default outside of its range");
  }
}

Parameter parameter_of(const epura_parameter& row, const std::string& projection) {
  require(row.name != nullptr && is_projection_name(row.name),
          projection + " has a parameter whose name is not lower case, digits and '-'");
  const std::string where = projection + ": parameter '" + row.name + "'";
  require(row.type <= EPURA_CHOICE, where + " is of unknown type " + number(row.type));
  const std::size_t max = row.type == EPURA_VECTOR ? std::size(row.initial) : 1;
  require(row.count >= 1 && row.count <= max, where + " has " + number(row.count) + " components");
  require(row.unit != nullptr && row.help != nullptr, where + " has no unit or no help");
  Parameter parameter{.name = row.name,
                      .type = static_cast<ParameterType>(row.type),
                      .unit = row.unit,
                      .help = row.help,
                      .choices = choices_of(row, where),
                      .initial = {row.initial, row.initial + row.count},
                      .min = row.least,
                      .max = row.most};
  check_initial(parameter, where);
  return parameter;
}

std::vector<Parameter> parameters_of(const epura_projection& row, const std::string& projection) {
  require(row.parameter_count == 0 || row.parameters != nullptr, projection + " has no table of parameters");
  require(row.parameter_count <= most_rows,
          projection + " claims to have " + number(row.parameter_count) + " parameters");
  std::vector<Parameter> parameters;
  std::set<std::string> names;
  for (std::size_t i = 0; i < row.parameter_count; ++i) {
    parameters.push_back(parameter_of(row_of(row.parameters, i, projection), projection));
    require(names.insert(parameters.back().name).second,
            projection + " has two parameters '" + parameters.back().name + "'");
  }
  return parameters;
}

ProjectionEntry entry_of(const epura_projection& row, std::size_t place, const std::filesystem::path& path) {
  const std::string nth = "projection " + number(place + 1);
  require(row.name != nullptr, nth + " has no name");
  require(is_projection_name(row.name), nth + ": the name '" + row.name + "' is not lower case, digits and '-'");
  const std::string projection = std::string("projection '") + row.name + "'";
  require(row.family != nullptr && row.summary != nullptr, projection + " has no family or no summary");
  require(row.project != nullptr, projection + " has no function");
  return {
      .name = row.name,
      .family = row.family,
      .summary = row.summary,
      .reference = row.reference == nullptr ? "" : row.reference,
      .parameters = parameters_of(row, projection),
      .plugin = path,
      .ask = [&row](const std::vector<double>& values, const Box& scene) { return call_plugin(row, values, scene); }};
}

}  // namespace

bool is_projection_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

std::vector<ProjectionEntry> read_plugin(const std::filesystem::path& path) {
  const epura_projection_list& list = list_of(entry_point(path));
  std::vector<ProjectionEntry> entries;
  std::set<std::string> names;
  for (std::size_t i = 0; i < list.count; ++i) {
    entries.push_back(entry_of(row_of(list.projections, i, "its list"), i, path));
    require(names.insert(entries.back().name).second, "offers two projections '" + entries.back().name + "'");
  }
  return entries;
}

}  // namespace epura::projection
