// SPDX-License-Identifier: Apache-2.0
// Finds edges at which a surface continues without a crease but its curvature changes: from a flat to a fillet, from a
// shaft to its rounded end.
#pragma once

#include <vector>

#include "edges/dihedral.hpp"

namespace epura::edges {

/// Returns for each edge of the model whether it is a tangent edge. In a mesh, curvature shows in the folds at the
/// sides of a facet, divided by the distance between them. An edge whose fold is less than `crease_angle` degrees, but
/// which is not flat, is tangent if the curvature across it is more than 2.5 times as large on one side as on the
/// other. So the facets of one cylinder, cone or sphere have none, whatever their number; scanned surfaces have some
/// that no designer intended.
std::vector<char> tangent_edges(const EdgeSurroundings& around, double crease_angle);

}  // namespace epura::edges
