// SPDX-License-Identifier: Apache-2.0
#include "projection/influence.hpp"

#include <algorithm>
#include <iterator>

#include "projection/answer.hpp"
#include "projection/probes.hpp"

namespace epura::projection {

namespace {

// Which quantities differ. The normal and the projectors of parallel views are directions, of which the length does not
// count.
std::array<bool, quantities> differences(const epura_view& a, const epura_view& b) {
  const auto differ = [](const auto& one, const auto& other) {
    return !std::equal(std::begin(one), std::end(one), std::begin(other));
  };
  const bool kinds = a.projectors != b.projectors;
  return {differ(a.point, b.point), differ(a.normal, b.normal),
          differ(a.up, b.up),       kinds || differ(a.projector, b.projector),
          a.scale != b.scale,       differ(a.window, b.window),
          a.front != b.front,       a.back != b.back};
}

}  // namespace

Influence influence_of(const ProjectionEntry& entry, const scene::ProjectionRequest& request, const Box& scene) {
  constexpr int enough = 3;  // answers with other values that are judged
  const ParameterValues values = values_of(entry.parameters, request.assignments, entry.name, "projection");
  const PluginAnswer usual = ask_plugin(entry, values, scene);
  Influence influence;
  for (std::size_t i = 0; i < entry.parameters.size() && !usual.refusal; ++i) {
    std::array<bool, quantities> changed{};
    int answers = 0;
    for (const std::vector<double>& other : probe_values(entry.parameters[i])) {
      if (answers == enough || other == values[i]) continue;
      ParameterValues changed_values = values;
      changed_values[i] = other;
      const PluginAnswer answer = ask_plugin(entry, changed_values, scene);
      if (answer.refusal || !fault_of(answer.view).empty()) continue;
      ++answers;
      const std::array<bool, quantities> now = differences(usual.view, answer.view);
      for (std::size_t q = 0; q < quantities; ++q) changed[q] = changed[q] || now[q];
    }
    for (std::size_t q = 0; q < quantities; ++q)
      if (changed[q]) influence[q].push_back(entry.parameters[i].name);
  }
  return influence;
}

}  // namespace epura::projection
