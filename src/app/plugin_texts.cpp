// SPDX-License-Identifier: Apache-2.0
#include "app/plugin_texts.hpp"

#include <cmath>

#include "base/text.hpp"

namespace epura {

namespace {

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ",") + format_number(value);
  return text;
}

std::string range_text(const projection::Parameter& parameter) {
  if (parameter.type == projection::ParameterType::choice) {
    std::string text;
    for (const std::string& choice : parameter.choices) text += (text.empty() ? "" : "|") + choice;
    return text;
  }
  const std::string kind = parameter.initial.size() == 1 ? "" : std::to_string(parameter.initial.size()) + " numbers";
  const bool bounded = std::isfinite(parameter.min) || std::isfinite(parameter.max);
  if (!bounded) return kind;
  return kind + (kind.empty() ? "" : " ") + format_number(parameter.min) + ".." + format_number(parameter.max);
}

}  // namespace

std::string usual_value(const projection::Parameter& parameter) {
  for (const double value : parameter.initial)
    if (std::isnan(value)) return "";
  if (parameter.type == projection::ParameterType::choice)
    return parameter.choices[static_cast<std::size_t>(parameter.initial[0])];
  return numbers(parameter.initial);
}

std::string values_text(const projection::Parameter& parameter) {
  const std::string usual = usual_value(parameter), range = range_text(parameter);
  return "default " + (usual.empty() ? "from the model" : usual) + (range.empty() ? "" : "; " + range) +
         (parameter.unit.empty() || parameter.unit == "1" ? "" : " [" + parameter.unit + "]");
}

}  // namespace epura
