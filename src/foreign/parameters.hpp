// SPDX-License-Identifier: Apache-2.0
// The table by which foreign code says what its parameters are, and values for them.
#pragma once

#include <epura/parameter_abi.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace epura::foreign {

enum class ParameterType { number, vector, choice };

/// One row of the table, as the plugin gave it.
struct Parameter {
  std::string name;
  ParameterType type;
  std::string unit;
  std::string help;
  std::vector<std::string> choices;
  std::vector<double> initial;  ///< NaN: found by the plugin
  double min, max;
};

// One function for both directions: what is put in is taken out (foreign/packing.hpp).
template <class Pack, class Values>
void pack_parameter(Pack& pack, Values& parameter) {
  pack(parameter.name), pack(parameter.type), pack(parameter.unit), pack(parameter.help), pack(parameter.choices);
  pack(parameter.initial), pack(parameter.min), pack(parameter.max);
}

/// For each row of a table one number, or the components of the vector; a choice is its place in the list.
using ParameterValues = std::vector<std::vector<double>>;

/// One after the other, as plugins get them.
std::vector<double> flattened(const ParameterValues& values);

/// What a user wrote: names and values of parameters.
using Assignments = std::vector<std::pair<std::string, std::string>>;

/// Those that hold unless others are given.
ParameterValues default_values(const std::vector<Parameter>& parameters);

/// The values of a table whose `owner` ("isometric") is called by its name in errors, `kind` ("projection") says what
/// it is. Throws Error{input} for what the table does not allow.
ParameterValues values_of(const std::vector<Parameter>& parameters, const Assignments& assignments,
                          const std::string& owner, const std::string& kind);

// What follows reads tables of C. A table is taken whole or not at all: what is wrong is thrown as Error{plugin}
// without a place.

[[noreturn]] void refuse(const std::string& reason);
void require(bool condition, const std::string& reason);

/// More rows are a sign of memory that was never filled in.
inline constexpr std::size_t most_rows = 1000;

/// Row `i` of a table whose rows are as long as its first one says: a newer plugin has longer rows than this program.
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

/// `owner` as errors call it: "projection 'isometric'".
std::vector<Parameter> read_parameters(const epura_parameter* table, std::size_t count, const std::string& owner);

/// Lower case, digits and '-'.
bool is_plugin_name(std::string_view name);

}  // namespace epura::foreign
