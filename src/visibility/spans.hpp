// Parts of an edge as intervals of its page parameter: ascending, disjoint.
#pragma once

#include <array>
#include <vector>

namespace epura {

using Spans = std::vector<std::array<double, 2>>;

/// Adds a span; what touches becomes one. The result does not depend on the order of adding.
void add_span(Spans& spans, const std::array<double, 2>& span);

/// Whether one span holds all from `from` to `to`.
bool covers(const Spans& spans, double from, double to);

/// Gaps shorter than `least` are closed, then spans shorter than `least` are dropped. An edge that is itself shorter is
/// one span or none, by its greater part.
void absorb_slivers(Spans& spans, double least);

}  // namespace epura
