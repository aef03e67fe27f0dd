// SPDX-License-Identifier: Apache-2.0
// What is left when round surfaces are found: planes, free-form faces, and slivers that belong to their neighbours.
#pragma once

#include <vector>

#include "features/facets.hpp"
#include "features/region.hpp"

namespace epura::features {

/// Gives every facet a region. Facets of free forms are told from planes by their folds: between facets of one smooth
/// surface they are small, go on from one to the next, and the facets on either side are about as wide.
void complete_regions(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

/// Takes the regions away that are rows of a free form's tessellation: facets between two circles lie on a cone, and
/// narrow strips of anything nearly do.
void dissolve_rows(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

/// Makes one region of neighbours that lie on the surface of the largest of them.
void merge_regions(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

}  // namespace epura::features
