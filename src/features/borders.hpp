// SPDX-License-Identifier: Apache-2.0
// Edges of the part: mesh edges between its faces, from corner to corner.
#pragma once

#include <array>
#include <vector>

#include "features/facets.hpp"
#include "features/recognise.hpp"
#include "features/region.hpp"

namespace epura::features {

/// Degrees by which facets on both sides of a piece of a border differ, and the length of the piece.
using AngleAlong = std::array<double, 2>;

/// The least angle that nine tenths of the length do not exceed. There is at least one piece.
double angle_of_most(std::vector<AngleAlong> angles);

/// A border is sharp or tangent as a whole, by the surfaces on both sides: tangent where they meet within
/// `tangent_angle` degrees along all of it, but for a tenth of its length. Ordered by their first edges.
std::vector<PartBorder> find_borders(const mesh::Mesh& mesh, const Facets& facets, const std::vector<int>& region_of,
                                     const std::vector<Region>& regions, double tangent_angle);

}  // namespace epura::features
