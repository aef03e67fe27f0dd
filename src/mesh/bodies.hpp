// SPDX-License-Identifier: Apache-2.0
// Which triangles belong together.
#pragma once

#include <vector>

#include "mesh/edge_table.hpp"

namespace epura::mesh {

/// A number for each triangle, the same for all that are connected through shared edges; counted from the first on.
///
/// Where two shells touch along an edge, four triangles or more share it. There those belong together between which
/// the edge has material: going round it, the outsides tell where material begins and ends. Shells that touch are
/// bodies of their own then, and one that touches itself stays one. Triangles whose outsides do not take turns, as of
/// sheets that cross, and those whose order around the edge is not certain stay together.
std::vector<int> connected_parts(const Mesh& mesh, const EdgeTable& table);

/// Replaces labels by 0, 1, ... in the order in which they appear; returns the labels that were there.
std::vector<int> renumber_labels(std::vector<int>& labels);

}  // namespace epura::mesh
