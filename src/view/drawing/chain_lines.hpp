// SPDX-License-Identifier: Apache-2.0
// The straight lines of a chain; curves are given as chords.
#pragma once

#include <cstddef>

#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Calls visit(from, to) for each line in order.
template <class Visit>
void visit_lines(const drawing::Chain& chain, const Visit& visit) {
  if (chain.points.empty()) return;
  const std::size_t lines = chain.points.size() - (chain.closed ? 0 : 1);
  for (std::size_t i = 0; i < lines; ++i) visit(chain.points[i], chain.points[(i + 1) % chain.points.size()]);
}

}  // namespace epura::drawing
