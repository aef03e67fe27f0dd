// SPDX-License-Identifier: Apache-2.0
// Which triangles form a body.
#pragma once

#include <vector>

#include "mesh/edge_table.hpp"

namespace epura::mesh {

/// A number for each triangle, the same for all that are connected through shared edges; counted from the first on.
///
/// Where two shells touch along an edge, four triangles or more share it. There those belong together that enclose
/// material: crossing them one after another around the edge one enters and leaves it by turns, and where it is follows
/// from the volume of all that touch. So shells that touch are separate bodies, and one that touches itself stays
/// one. Which way round triangles run in the file does not matter. Where the order around an edge is not certain, or
/// this is contradictory, as for one-sided surfaces, all faces at the edge stay together.
std::vector<int> connected_parts(const Mesh& mesh, const EdgeTable& table);

/// Replaces labels by 0, 1, ... in the order in which they appear; returns the labels that were there.
std::vector<int> renumber_labels(std::vector<int>& labels);

}  // namespace epura::mesh
