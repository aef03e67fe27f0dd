// SPDX-License-Identifier: Apache-2.0
// The table with which foreign code describes its parameters, and values for them.
#pragma once

#include <epura/parameter_abi.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace epura::foreign {

enum class ParameterType { number, vector, choice };

/// One row of the table, as supplied by the plugin.
struct Parameter {
  std::string name;
  ParameterType type;
  std::string unit;
  std::string help;
  std::vector<std::string> choices;
  std::vector<double> initial;  ///< NaN: determined by the plugin
  double min, max;
};

// One function for both directions, so that values are unpacked as they were packed (foreign/packing.hpp).
template <class Pack, class Values>
void pack_parameter(Pack& pack, Values& parameter) {
  pack(parameter.name), pack(parameter.type), pack(parameter.unit), pack(parameter.help), pack(parameter.choices);
  pack(parameter.initial), pack(parameter.min), pack(parameter.max);
}

/// For each row of a table one number, or the components of a vector; a choice is its index in the list.
using ParameterValues = std::vector<std::vector<double>>;

/// All numbers in one list, as plugins receive them.
std::vector<double> flattened(const ParameterValues& values);

/// Names and values of parameters as written by a user.
using Assignments = std::vector<std::pair<std::string, std::string>>;

/// The values that apply unless others are given.
ParameterValues default_values(const std::vector<Parameter>& parameters);

/// Returns values for the table of `owner` ("isometric"), which errors call by its `kind` ("projection") and name.
/// Throws Error{input} for anything that the table does not allow.
ParameterValues values_of(const std::vector<Parameter>& parameters, const Assignments& assignments,
                          const std::string& owner, const std::string& kind);

// The following functions read C tables. A table is accepted as a whole or not at all: faults are thrown as
// Error{plugin} without a place.

[[noreturn]] void refuse(const std::string& reason);
void require(bool condition, const std::string& reason);

/// More rows indicate uninitialised memory.
inline constexpr std::size_t max_rows = 1000;

/// Returns row `i` of a table whose rows are as long as its first one states: a newer plugin has longer rows than this
/// program.
template <class Row>
const Row& row_of(const Row* first, std::size_t i, const std::string& whose) {
  require(first->size >= sizeof(Row) && first->size % alignof(Row) == 0,
          whose + " has rows of " + std::to_string(first->size) + " bytes, at least " + std::to_string(sizeof(Row)) +
              " are needed");
  const auto* bytes = reinterpret_cast<const std::byte*>(first) + i * first->size;
  const Row& row = *reinterpret_cast<const Row*>(bytes);
  require(row.size == first->size, whose + " has rows of different sizes");
  return row;
}

/// `owner` as in errors: "projection 'isometric'".
std::vector<Parameter> read_parameters(const epura_parameter* table, std::size_t count, const std::string& owner);

/// Lower-case letters, digits and '-'.
bool is_plugin_name(std::string_view name);

}  // namespace epura::foreign
