// SPDX-License-Identifier: Apache-2.0
// A request and the table of its projection become values, the plugin's answer to them becomes a Projection.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/answer.hpp"
#include "projection/catalogue.hpp"

namespace epura::projection {

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
    if (!list.empty()) list += ", ";
    list += choice;
  }
  refuse_value(where, "'" + text + "' is not one of " + list);
}

std::vector<double> value_of(const Parameter& parameter, const std::string& text, const std::string& where) {
  if (parameter.type == ParameterType::choice) return choice_value(parameter, text, where);
  const auto numbers = parse_numbers(text);
  if (!numbers) refuse_value(where, "'" + text + "' is not a number" + (parameter.initial.size() > 1 ? " list" : ""));
  if (numbers->size() != parameter.initial.size())
    refuse_value(where, "takes " + std::to_string(parameter.initial.size()) + " numbers with commas between, not " +
                            std::to_string(numbers->size()));
  for (const double number : *numbers) {
    if (!std::isfinite(number)) refuse_value(where, "must be finite");
    if (number < parameter.min || number > parameter.max)
      refuse_value(where, "is " + format_number(number) + ", allowed is " + range_of(parameter));
  }
  return *numbers;
}

ParameterValues values_of(const ProjectionEntry& entry, const scene::ProjectionRequest& request) {
  ParameterValues values = default_values(entry);
  std::vector<std::string> names;
  for (const Parameter& parameter : entry.parameters) names.push_back(parameter.name);
  for (const auto& [key, text] : request.assignments) {
    const std::string where = entry.name + ":" + key;
    const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), key) - names.begin());
    if (names.empty()) refuse_value(where, "this projection has no parameters");
    if (place == names.size()) refuse_value(where, "no such parameter", did_you_mean(key, names));
    values[place] = value_of(entry.parameters[place], text, where);
  }
  return values;
}

/// A plugin must answer for its own defaults; what the user gave is the user's to mend.
[[noreturn]] void refuse_answer(const ProjectionEntry& entry, const scene::ProjectionRequest& request,
                                const std::string& reason) {
  if (!request.assignments.empty()) refuse_value(entry.name, reason);
  throw Error(ErrorKind::plugin, entry.plugin.string(), "'" + entry.name + "': " + reason);
}

}  // namespace

Projection make_projection(const ProjectionEntry& entry, const scene::ProjectionRequest& request, const Box& scene) {
  const ParameterValues values = values_of(entry, request);
  const PluginAnswer answer = ask_plugin(entry, values, scene);
  if (answer.refusal) refuse_answer(entry, request, *answer.refusal);
  if (const std::string fault = fault_of(answer.view); !fault.empty()) refuse_answer(entry, request, fault);
  Projection projection = projection_of(answer.view);
  projection.name = entry.name;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::all_of(values[i].begin(), values[i].end(), [](double v) { return std::isfinite(v); }))
      projection.values.emplace_back(entry.parameters[i].name, values[i]);
  return projection;
}

}  // namespace epura::projection
