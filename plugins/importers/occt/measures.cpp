// SPDX-License-Identifier: Apache-2.0
#include "measures.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace occt {

namespace {

struct UnitOfMeasure {
  double size = 0;  ///< mm or degrees
  bool is_angle = false;
};

// A unit is made from one made from another: feet from inches from millimetres.
constexpr int deepest_unit = 4;

/// More than a double has.
constexpr int most_decimals = 16;

std::optional<UnitOfMeasure> unit_of(const StepGraph& graph, EntityNumber number, int depth);

double prefix_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 10> prefixes{{{".EXA.", 1e18},
                                                                          {".GIGA.", 1e9},
                                                                          {".MEGA.", 1e6},
                                                                          {".KILO.", 1e3},
                                                                          {".DECI.", 1e-1},
                                                                          {".CENTI.", 1e-2},
                                                                          {".MILLI.", 1e-3},
                                                                          {".MICRO.", 1e-6},
                                                                          {".NANO.", 1e-9},
                                                                          {"$", 1}}};
  const auto found = std::find_if(prefixes.begin(), prefixes.end(), [&](const auto& row) { return row.first == name; });
  return found == prefixes.end() ? std::nan("") : found->second;
}

// SI_UNIT(prefix, name), after the dimensions if it stands alone.
std::optional<UnitOfMeasure> si_unit(const Record& record) {
  const std::vector<std::string_view> arguments = separated(record.arguments);
  if (arguments.size() < 2) return std::nullopt;
  const double prefix = prefix_of(arguments[arguments.size() - 2]);
  if (std::isnan(prefix)) return std::nullopt;
  if (arguments.back() == ".METRE.") return UnitOfMeasure{1000 * prefix, false};
  if (arguments.back() == ".RADIAN.") return UnitOfMeasure{180 / std::numbers::pi * prefix, true};
  return std::nullopt;
}

// The value and its unit in whatever form of a measure.
std::optional<std::pair<std::string_view, std::string_view>> parts_of_measure(const Statement& statement) {
  for (const Record& record : statement.records) {
    if (record.keyword.find("MEASURE") == std::string_view::npos) continue;
    const std::vector<std::string_view> arguments = separated(record.arguments);
    const bool is_named = record.keyword == "MEASURE_REPRESENTATION_ITEM";
    if (arguments.size() < (is_named ? 3u : 2u)) continue;
    const std::size_t first = is_named ? 1 : 0;
    return std::pair(arguments[first], arguments[first + 1]);
  }
  return std::nullopt;
}

std::optional<UnitOfMeasure> unit_of(const StepGraph& graph, EntityNumber number, int depth) {
  const Statement* statement = graph.find(number);
  if (statement == nullptr || depth > deepest_unit) return std::nullopt;
  if (const Record* si = record_of(*statement, "SI_UNIT")) return si_unit(*si);
  const Record* conversion = record_of(*statement, "CONVERSION_BASED_UNIT");
  if (conversion == nullptr) return std::nullopt;
  const Statement* factor = graph.find(reference_in(last_argument_of(*conversion)));
  const auto parts = factor == nullptr ? std::nullopt : parts_of_measure(*factor);
  if (!parts) return std::nullopt;
  std::optional<UnitOfMeasure> unit = unit_of(graph, reference_in(parts->second), depth + 1);
  if (unit) unit->size *= number_in(parts->first);
  return unit && unit->size > 0 && std::isfinite(unit->size) ? unit : std::nullopt;
}

// "NR2 1.3": a number with one digit before and three behind its point.
int decimals_in(std::string_view format) {
  const std::size_t point = format.rfind('.');
  int decimals = -1;
  if (point != std::string_view::npos)
    std::from_chars(format.data() + point + 1, format.data() + format.size(), decimals);
  return decimals <= most_decimals ? decimals : -1;
}

// The product of decimals of a file, with the digits that a double keeps of any decimal: 0.03 in are 0.762 mm.
double converted(double number, double unit) {
  std::array<char, 32> text{};
  double value = number * unit;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general,
                                 std::numeric_limits<double>::digits10);
  if (std::isfinite(value)) std::from_chars(text.data(), end.ptr, value);
  return value;
}

}  // namespace

double number_in(std::string_view text) {
  if (const std::size_t open = text.find('('); open != std::string_view::npos) text.remove_prefix(open + 1);
  text.remove_prefix(std::min(text.find_first_not_of(" +"), text.size()));
  double number = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), number);
  return std::isfinite(number) ? number : std::nan("");
}

void qualify(Measure& measure, const StepGraph& graph, const std::vector<EntityNumber>& qualifiers) {
  for (const EntityNumber number : qualifiers) {
    const Statement* statement = graph.find(number);
    if (statement == nullptr) continue;
    if (const Record* type = record_of(*statement, "TYPE_QUALIFIER"))
      measure.qualifier = unquoted(argument_of(*type, 0));
    if (const Record* format = record_of(*statement, "VALUE_FORMAT_TYPE_QUALIFIER"))
      measure.decimals = decimals_in(unquoted(argument_of(*format, 0)));
  }
}

Measure measure_of(const StepGraph& graph, EntityNumber number) {
  Measure measure;
  const Statement* statement = graph.find(number);
  const auto parts = statement == nullptr ? std::nullopt : parts_of_measure(*statement);
  if (!parts) return measure;
  for (const std::string_view keyword : {"REPRESENTATION_ITEM", "MEASURE_REPRESENTATION_ITEM"})
    if (const Record* item = record_of(*statement, keyword); item != nullptr && measure.name.empty())
      measure.name = unquoted(argument_of(*item, 0));
  if (const Record* qualified = record_of(*statement, "QUALIFIED_REPRESENTATION_ITEM"))
    qualify(measure, graph, references_in(qualified->arguments));
  const auto unit = unit_of(graph, reference_in(parts->second), 0);
  measure.has_unit = unit.has_value();
  if (unit) {
    measure.unit = converted(1, unit->size);
    measure.is_angle = unit->is_angle;
    measure.value = converted(number_in(parts->first), unit->size);
  }
  return measure;
}

double length_unit_of(const StepGraph& graph, EntityNumber context) {
  const Statement* statement = graph.find(context);
  const Record* units = statement == nullptr ? nullptr : record_of(*statement, "GLOBAL_UNIT_ASSIGNED_CONTEXT");
  if (units != nullptr)
    for (const EntityNumber number : references_in(units->arguments))
      if (const auto unit = unit_of(graph, number, 0); unit && !unit->is_angle) return unit->size;
  return std::nan("");
}

double length_unit_in(const StepGraph& graph) {
  for (const auto& [number, statement] : graph.statements())
    if (record_of(statement, "GLOBAL_UNIT_ASSIGNED_CONTEXT") != nullptr)
      if (const double unit = length_unit_of(graph, number); !std::isnan(unit)) return unit;
  return 1;
}

std::string printed_length(double value) {
  constexpr int digits = 9;
  std::array<char, 32> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr};
}

}  // namespace occt
