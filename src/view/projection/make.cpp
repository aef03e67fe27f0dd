// SPDX-License-Identifier: Apache-2.0
// A request and the table of its projection become values; the plugin's answer to them becomes a Projection.
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "projection/answer.hpp"
#include "projection/catalogue.hpp"

namespace epura::projection {

namespace {

/// A plugin must have an answer to its own defaults; values given by the user are for the user to correct.
[[noreturn]] void refuse_answer(const ProjectionEntry& entry, const scene::ProjectionRequest& request,
                                const std::string& reason) {
  if (!request.assignments.empty()) throw Error(ErrorKind::input, entry.name, reason);
  throw Error(ErrorKind::plugin, entry.plugin.string(), "'" + entry.name + "': " + reason);
}

bool has_parameter(const ProjectionEntry& entry, const std::string& name) {
  return std::any_of(entry.parameters.begin(), entry.parameters.end(),
                     [&](const Parameter& parameter) { return parameter.name == name; });
}

// Who misses a parameter may mean another projection of the family: cavalier has no ratio, but oblique has, and cabinet
// is half. Empty if no other one has it.
std::string hint_at_family(const ProjectionEntry& entry, const std::string& parameter) {
  std::string having, others;
  for (const ProjectionEntry& other : load_catalogue({entry.plugin.parent_path()}).entries) {
    if (other.family != entry.family || other.name == entry.name) continue;
    const bool has = has_parameter(other, parameter);
    (has ? having : others) += "; " + other.name + (has ? " has it: " : ": ") + other.summary;
  }
  return having.empty() ? "" : having.substr(2) + others;
}

}  // namespace

Projection make_projection(const ProjectionEntry& entry, const scene::ProjectionRequest& request, const Box& scene) {
  for (const auto& [name, text] : request.assignments)
    if (!has_parameter(entry, name))
      if (const std::string hint = hint_at_family(entry, name); !hint.empty())
        throw Error(ErrorKind::input, entry.name + ":" + name, "no such parameter", hint);
  const ParameterValues values = values_of(entry.parameters, request.assignments, entry.name, "projection");
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
