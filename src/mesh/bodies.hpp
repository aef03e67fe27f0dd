// SPDX-License-Identifier: Apache-2.0
// Which triangles belong together.
#pragma once

#include <vector>

#include "mesh/edge_table.hpp"

namespace epura::mesh {

/// A number for each triangle, the same for all that are connected through shared edges; counted from the first on.
std::vector<int> connected_parts(std::size_t triangle_count, const EdgeTable& table);

/// Replaces labels by 0, 1, ... in the order in which they appear; returns the labels that were there.
std::vector<int> renumber_labels(std::vector<int>& labels);

}  // namespace epura::mesh
