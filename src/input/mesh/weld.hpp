// SPDX-License-Identifier: Apache-2.0
// Merges points at the same position into one vertex.
#pragma once

#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// Returns for each point the lowest-numbered point at exactly the same position. 0 and -0 are equal; a point that is
/// not finite equals no other point.
std::vector<int> same_places(const Points& points);

/// Removes the points that `representative` replaces by another, and renumbers the others in their original order.
void renumber(Points& points, std::vector<int>& corners, std::vector<int> representative);

}  // namespace epura::mesh
