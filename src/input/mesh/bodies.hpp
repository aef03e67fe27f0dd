// SPDX-License-Identifier: Apache-2.0
// Assigns triangles to bodies.
#pragma once

#include <vector>

#include "mesh/edge_table.hpp"

namespace epura::mesh {

/// Returns a number for each triangle, equal for all triangles that are connected through shared edges, in order of
/// first appearance.
///
/// Along an edge where two shells touch, four or more triangles meet. Those that enclose material together are joined:
/// going around the edge, one enters and leaves material alternately, and the volume of all touching shells tells which
/// side is inside. So shells that touch are separate bodies, and a shell that touches itself remains one body. The
/// orientation of triangles in the file does not matter. If the order around an edge is uncertain or the orientation
/// contradictory, as for one-sided surfaces, all faces at the edge are joined.
std::vector<int> connected_parts(const Mesh& mesh, const EdgeTable& table);

/// Replaces labels by 0, 1, ... in order of first appearance; returns the original labels.
std::vector<int> renumber_labels(std::vector<int>& labels);

}  // namespace epura::mesh
