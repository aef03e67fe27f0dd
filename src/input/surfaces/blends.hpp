// SPDX-License-Identifier: Apache-2.0
// Fillets and rounded rims of cylinders and cones, where the facets of the blend itself do not tell what it is.
//
// Mesh generators fill a narrow blend with slivers, from which no curvature can be estimated. But it has the axis of
// the surface that it continues, and is tangent to it along a circle: that leaves its radius alone to be found.
#pragma once

#include <vector>

#include "surfaces/facets.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

/// Adds tori that continue cylinders, cones and other tori beyond a circle around their axis, as far as their facets
/// have no region yet. `region_of` is by facet, -1 for none.
Regions grow_blends(const Facets& facets, Regions found);

}  // namespace epura::surfaces
