// SPDX-License-Identifier: Apache-2.0
// Spans as sets of places: all ascending and disjoint.
#pragma once

#include <vector>

#include "visibility/spans.hpp"
#include "visibility/visibility.hpp"

namespace epura {

/// Those of edge e.
Spans hidden_parts(const HiddenSpans& hidden, std::size_t e);

/// The spans of all edges in their order; nothing is undecided.
HiddenSpans gather(const std::vector<Spans>& by_edge);

/// What is in both.
Spans common(const Spans& a, const Spans& b);
/// What of `a` is not in `b`.
Spans without(const Spans& a, const Spans& b);
/// What is in one or both; what touches becomes one.
Spans united(Spans a, const Spans& b);

inline Spans complement(const Spans& a) { return without({{0.0, 1.0}}, a); }

}  // namespace epura
