// SPDX-License-Identifier: Apache-2.0
// Merges points at the same position into one vertex.
#pragma once

#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// For each point the lowest-numbered point at exactly the same place. 0 and -0 are one place; a point that is not
/// finite equals no other point.
std::vector<int> same_places(const Points& points);

/// Leaves out the points that `representative` replaces by another, and numbers the rest in their old order.
void renumber(Points& points, std::vector<int>& corners, std::vector<int> representative);

}  // namespace epura::mesh
