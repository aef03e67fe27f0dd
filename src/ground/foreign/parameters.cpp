// SPDX-License-Identifier: Apache-2.0
#include "foreign/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"

namespace epura::foreign {

namespace {

[[noreturn]] void refuse_value(const std::string& where, const std::string& reason, const std::string& hint = {}) {
  throw Error(ErrorKind::input, where, reason, hint);
}

std::string range_of(const Parameter& parameter) {
  const std::string unit = parameter.unit.empty() || parameter.unit == "1" ? "" : " " + parameter.unit;
  if (std::isinf(parameter.min)) return format_number(parameter.max) + unit + " or less";
  if (std::isinf(parameter.max)) return format_number(parameter.min) + unit + " or more";
  return format_number(parameter.min) + " to " + format_number(parameter.max) + unit;
}

std::vector<double> choice_value(const Parameter& parameter, const std::string& text, const std::string& where) {
  const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
  if (found != parameter.choices.end()) return {static_cast<double>(found - parameter.choices.begin())};
  std::string list;
  for (const std::string& choice : parameter.choices) {
    append_to_list(list, choice);
  }
  refuse_value(where, "'" + text + "' is not one of " + list);
}

std::vector<double> value_of(const Parameter& parameter, const std::string& text, const std::string& where) {
  if (parameter.type == ParameterType::choice) return choice_value(parameter, text, where);
  const auto numbers = parse_numbers(text);
  if (!numbers) refuse_value(where, "'" + text + "' is not a number" + (parameter.initial.size() > 1 ? " list" : ""));
  if (numbers->size() != parameter.initial.size())
    refuse_value(where, "takes " + std::to_string(parameter.initial.size()) + " numbers separated by commas, not " +
                            std::to_string(numbers->size()));
  for (const double number : *numbers) {
    if (!std::isfinite(number)) refuse_value(where, "must be finite");
    if (!is_usable(number))
      refuse_value(where, "is " + format_number(number) + ", allowed is up to " + format_number(largest_number));
    if (number < parameter.min || number > parameter.max)
      refuse_value(where, "is " + format_number(number) + ", allowed is " + range_of(parameter));
  }
  return *numbers;
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
    require(fits, where + " has a default outside its range");
  }
}

Parameter parameter_of(const epura_parameter& row, const std::string& owner) {
  require(row.name != nullptr && is_plugin_name(row.name),
          owner + " has a parameter whose name is not lower case, digits and '-'");
  const std::string where = owner + ": parameter '" + row.name + "'";
  require(row.type <= EPURA_CHOICE, where + " is of unknown type " + std::to_string(row.type));
  const std::size_t max = row.type == EPURA_VECTOR ? std::size(row.initial) : 1;
  require(row.count >= 1 && row.count <= max, where + " has " + std::to_string(row.count) + " components");
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

}  // namespace

ParameterValues default_values(const std::vector<Parameter>& parameters) {
  ParameterValues values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.initial);
  return values;
}

std::vector<double> flattened(const ParameterValues& values) {
  std::vector<double> numbers;
  for (const std::vector<double>& value : values) numbers.insert(numbers.end(), value.begin(), value.end());
  return numbers;
}

ParameterValues values_of(const std::vector<Parameter>& parameters, const Assignments& assignments,
                          const std::string& owner, const std::string& kind) {
  ParameterValues values = default_values(parameters);
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  for (const auto& [key, text] : assignments) {
    const std::string where = owner + ":" + key;
    const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), key) - names.begin());
    if (names.empty()) refuse_value(where, "this " + kind + " has no parameters");
    if (place == names.size()) refuse_value(where, "no such parameter", did_you_mean(key, names));
    values[place] = value_of(parameters[place], text, where);
  }
  return values;
}

void refuse(const std::string& reason) { throw Error(ErrorKind::plugin, "", reason); }

void require(bool condition, const std::string& reason) {
  if (!condition) refuse(reason);
}

std::vector<Parameter> read_parameters(const epura_parameter* table, std::size_t count, const std::string& owner) {
  require(count == 0 || table != nullptr, owner + " has no table of parameters");
  require(count <= max_rows, owner + " claims to have " + std::to_string(count) + " parameters");
  std::vector<Parameter> parameters;
  std::set<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    parameters.push_back(parameter_of(row_of(table, i, owner), owner));
    require(names.insert(parameters.back().name).second,
            owner + " has two parameters '" + parameters.back().name + "'");
  }
  return parameters;
}

bool is_plugin_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

}  // namespace epura::foreign
