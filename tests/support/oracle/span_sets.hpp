// SPDX-License-Identifier: Apache-2.0
// Spans as sets of positions: all are ascending and disjoint.
#pragma once

#include <vector>

#include "visibility/spans.hpp"
#include "visibility/visibility.hpp"

namespace epura {

/// The hidden spans of edge e.
visibility::Spans hidden_parts(const visibility::HiddenSpans& hidden, std::size_t e);

/// The spans of all edges in their order; nothing is undecided.
visibility::HiddenSpans gather(const std::vector<visibility::Spans>& by_edge);

/// Intersection.
visibility::Spans common(const visibility::Spans& a, const visibility::Spans& b);
/// Difference: `a` without `b`.
visibility::Spans without(const visibility::Spans& a, const visibility::Spans& b);
/// Union; spans that touch are merged.
visibility::Spans united(visibility::Spans a, const visibility::Spans& b);

inline visibility::Spans complement(const visibility::Spans& a) { return without({{0.0, 1.0}}, a); }

}  // namespace epura
