// SPDX-License-Identifier: Apache-2.0
// Parts of an edge as intervals of its page parameter: ascending, disjoint.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace epura::visibility {

using Spans = std::vector<std::array<double, 2>>;

/// Adds a span; what touches becomes one. The result does not depend on the order of adding.
void add_span(Spans& spans, const std::array<double, 2>& span);

/// Whether one span holds all from `from` to `to`.
bool covers(const Spans& spans, double from, double to);

/// From the first place of [from, to] to the last that further spans may change, on a line from 0 to `length`. Gaps
/// that absorb_slivers closes are left out: shorter than `min`, next to a span that is not.
std::optional<std::array<double, 2>> open_part(const Spans& spans, double from, double to, double min,
                                               double length = 1);

/// Gaps shorter than `min` are closed, then spans shorter than `min` are dropped. An edge that is itself shorter is
/// one span or none, by its greater part.
void absorb_slivers(Spans& spans, double min);

}  // namespace epura::visibility
