// SPDX-License-Identifier: Apache-2.0
// Edges where a surface continues without a crease but its curvature changes: from a flat to a fillet, from a shaft to
// its rounded end.
#pragma once

#include <vector>

#include "edges/dihedral.hpp"

namespace epura::edges {

/// By edge of the model: whether it is a tangent edge. A mesh tells curvature by its folds: those of a facet's sides,
/// over the distance between them. An edge that folds by less than `crease_angle` degrees, but is not flat, is tangent
/// where the curvature across it is more than 2.5 times as large on one of its sides as on the other. So the facets of
/// one cylinder, cone or sphere have none, whatever their number; and scanned surfaces have some that no designer
/// meant.
std::vector<char> tangent_edges(const EdgeSurroundings& around, double crease_angle);

}  // namespace epura::edges
