// SPDX-License-Identifier: Apache-2.0
// Handles what remains when round surfaces have been found: planes, free-form faces, and slivers, which belong to their
// neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "surfaces/facets.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

/// Assigns a region to every facet. Facets of free forms are distinguished from planes by their folds: between facets
/// of one smooth surface, folds are small and continue from one to the next, and the facets on both sides have about
/// the same width.
Regions complete_regions(const Facets& facets, Regions found);

/// Removes regions, from the one with number `first` on, that are rows of a free form's tessellation: facets between
/// two circles lie on a cone, and narrow strips of anything nearly do.
Regions dissolve_rows(const Facets& facets, Regions found, std::size_t first = 0);

/// Merges neighbours that lie on the surface of the largest of them into one region.
Regions merge_regions(const Facets& facets, Regions found);

}  // namespace epura::surfaces
