// SPDX-License-Identifier: Apache-2.0
// Splits polygons that repeat a corner.
#pragma once

#include <span>
#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// Returns the polygons of which a ring of corners consists. The ring is divided at a corner that occurs twice if both
/// parts have the same orientation, like two loops that touch; a part with the opposite orientation is a hole connected
/// by a bridge, and is kept. Spikes, which lead to a corner and back, bound nothing and are removed, as are loops that
/// are gone round again.
std::vector<std::vector<int>> simple_rings(std::span<const int> ring, const Points& points);

/// Whether a corner occurs twice.
bool repeats_corner(std::span<const int> ring);

}  // namespace epura::mesh
