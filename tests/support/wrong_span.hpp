// SPDX-License-Identifier: Apache-2.0
// Drawings against the truth in rational numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "oracle/span_sets.hpp"
#include "oracle/truth.hpp"
#include "shapes.hpp"

namespace epura::test {

/// The greatest wrong span that counts as rounding, in parts of the drawing.
inline constexpr double most_wrong = 1e-6;

struct WrongSpan {
  double longest = 0;  ///< in parts of the drawing
  std::string words;
};

/// The longest span of a drawing that is shown hidden and is visible, or the other way.
inline WrongSpan longest_wrong(const Result& r, const view::ViewLimits& limits = {}) {
  const verify::VerifyInput drawn{r.world, r.view.projection, limits, r.drawn, r.hidden, r.drawing};
  const std::vector<EdgeTruth> truth = find_truth(drawn, r.view, {.pairs = HUGE_VAL});
  if (truth.size() != r.drawn.edges.size()) return {HUGE_VAL, "the truth about some edges is unknown"};
  WrongSpan wrong;
  for (const EdgeTruth& edge : truth) {
    const visibility::Spans shown = hidden_parts(r.hidden, static_cast<std::size_t>(edge.edge));
    const auto& [p, q] = r.drawn.edges[static_cast<std::size_t>(edge.edge)].vertex;
    const view::PageVertex &from = r.view.vertices[p], &to = r.view.vertices[q];
    const double length = std::hypot(from.x - to.x, from.y - to.y) / r.view.extent;
    for (const auto& [spans, what] : {std::pair(without(edge.surely, shown), "hidden but shown visible"),
                                      std::pair(without(shown, edge.perhaps), "visible but shown hidden")})
      for (const auto& [begin, end] : spans) {
        if ((end - begin) * length <= wrong.longest) continue;
        std::ostringstream words;
        words << what << ", edge " << edge.edge << " from " << begin << " to " << end;
        wrong = {(end - begin) * length, words.str()};
      }
  }
  return wrong;
}

}  // namespace epura::test
