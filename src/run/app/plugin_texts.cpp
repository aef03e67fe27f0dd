// SPDX-License-Identifier: Apache-2.0
#include "app/plugin_texts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.hpp"
#include "base/utf8.hpp"

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

const char* word(foreign::Verdict verdict) {
  switch (verdict) {
    case foreign::Verdict::passed:
      return "passed";
    case foreign::Verdict::failed:
      return "FAILED";
    case foreign::Verdict::skipped:
      return "skipped";
  }
  return "";
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

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

void print(const std::string& line) { std::printf("%s\n", printable(line).c_str()); }

void print_parameters(const std::vector<projection::Parameter>& parameters) {
  for (const projection::Parameter& parameter : parameters) {
    print("  " + padded(parameter.name, 16) + parameter.help);
    print("  " + padded("", 16) + values_text(parameter));
  }
}

void print_check(const foreign::CheckResult& result) {
  print("  " + padded(result.name, 12) + padded(word(result.verdict), 9) + result.what);
  if (!result.fault.empty()) print("  " + padded("", 21) + result.fault);
  std::fflush(stdout);
}

}  // namespace epura
