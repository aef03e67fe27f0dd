// SPDX-License-Identifier: Apache-2.0
// Parts of an edge as intervals of its page parameter: ascending, disjoint.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace epura::visibility {

using Spans = std::vector<std::array<double, 2>>;

/// Adds a span and merges those that touch. The result does not depend on the order of additions.
void add_span(Spans& spans, const std::array<double, 2>& span);

/// Whether one span holds all from `from` to `to`.
bool covers(const Spans& spans, double from, double to);

/// Returns the smallest interval that contains every part of [from, to] which further spans may change, on a line from
/// 0 to `length`. Gaps that absorb_slivers closes do not count: those shorter than `min` and next to a span that is
/// not.
std::optional<std::array<double, 2>> open_part(const Spans& spans, double from, double to, double min,
                                               double length = 1);

/// Closes gaps shorter than `min`, then drops spans shorter than `min`. An edge that is itself shorter becomes one span
/// or none, whichever is the greater part.
void absorb_slivers(Spans& spans, double min);

}  // namespace epura::visibility
