// SPDX-License-Identifier: Apache-2.0
// Contours that are drawn on their surface, and not on its facets, may go back and forth on one line. Dashes would
// start anew at each turn.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::drawing {

/// Returns the points of a line in an order in which it goes forwards: where it turns back and forth again within a few
/// points, these are passed in the order in which they lie along it, if all ink stays within `distance`. The first
/// point stays, so does the last one of an open line, and a line that turns back once.
std::vector<Vec2> go_forwards(std::vector<Vec2> points, bool closed, double distance);

}  // namespace epura::drawing
