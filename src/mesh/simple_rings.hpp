// SPDX-License-Identifier: Apache-2.0
// Splits polygons that repeat a corner.
#pragma once

#include <span>
#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// The polygons of which a ring of corners consists. It is divided at a corner that it names twice where both parts
/// turn the same way round, as two loops that touch do; a part that turns the other way is a hole with a bridge to it
/// and stays. A way there and back is left out: it bounds nothing.
std::vector<std::vector<int>> simple_rings(std::span<const int> ring, const Points& points);

/// Whether a corner is named twice.
bool repeats_corner(std::span<const int> ring);

}  // namespace epura::mesh
