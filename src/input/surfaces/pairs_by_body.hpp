// SPDX-License-Identifier: Apache-2.0
// Where bodies touch, their triangles share edges; each body has its own two sides there.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.hpp"

namespace epura::surfaces {

/// The two triangles of one body at an edge, in the order of the mesh.
using TrianglePair = std::array<int, 2>;

/// Returns the pair of each body at an edge; none if any body has one triangle there, or more than two. Two triangles
/// alone are a pair, whatever their bodies are called.
std::vector<TrianglePair> pairs_by_body(const mesh::Mesh& mesh, const mesh::MeshEdge& edge);

}  // namespace epura::surfaces
