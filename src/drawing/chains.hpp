// SPDX-License-Identifier: Apache-2.0
// Touching segments of the same style, model and named body, joined end to end into polylines.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Every segment is in exactly one chain. Where more than two ends meet, the straightest continuations are joined.
/// Corners at which a chain runs straight on within `tolerance` mm are left out. Throws OutOfTime.
std::vector<Chain> chain_segments(const std::vector<Segment>& segments, double tolerance,
                                  const Progress& progress = {});

}  // namespace epura::drawing
