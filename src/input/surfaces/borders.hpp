// SPDX-License-Identifier: Apache-2.0
// Edges of the part: chains of mesh edges between its faces, from corner to corner.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "surfaces/facets.hpp"
#include "surfaces/recognise.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

/// The angle in degrees between the facets on both sides of a piece of a border, and the length of the piece.
using AngleAlong = std::array<double, 2>;

/// Returns the least angle that is not exceeded over a fraction of the length. There must be at least one piece.
double angle_of_most(std::vector<AngleAlong> angles, double most);

/// A border is sharp or tangent as a whole, as determined by the surfaces on both sides: tangent if they meet within
/// `tangent_angle` degrees along all of it, except a tenth of its length. Borders are ordered by their first edges.
std::vector<PartBorder> find_borders(const mesh::Mesh& mesh, const Facets& facets, const std::vector<int>& region_of,
                                     const std::vector<Region>& regions, double tangent_angle);

/// The two triangles of one body at an edge, in the order of the mesh.
using TrianglePair = std::array<int, 2>;

/// Returns the pair of each body at an edge; none if any body has one triangle there, or more than two. Two triangles
/// alone are a pair, whatever their bodies are called.
std::vector<TrianglePair> pairs_by_body(const mesh::Mesh& mesh, const mesh::MeshEdge& edge);

}  // namespace epura::surfaces
