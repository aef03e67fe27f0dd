// SPDX-License-Identifier: Apache-2.0
// Handles what remains when round surfaces have been found: planes, free-form faces, and slivers, which belong to their
// neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "features/facets.hpp"
#include "features/region.hpp"

namespace epura::features {

/// Assigns a region to every facet. Facets of free forms are distinguished from planes by their folds: between facets
/// of one smooth surface, folds are small and continue from one to the next, and the facets on both sides have about
/// the same width.
void complete_regions(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

/// Removes regions, from the one with number `first` on, that are rows of a free form's tessellation: facets between
/// two circles lie on a cone, and narrow strips of anything nearly do.
void dissolve_rows(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions,
                   std::size_t first = 0);

/// Merges neighbours that lie on the surface of the largest of them into one region.
void merge_regions(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

}  // namespace epura::features
