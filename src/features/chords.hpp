// SPDX-License-Identifier: Apache-2.0
// Facets that are pieces of a round face although they face elsewhere.
#pragma once

#include <vector>

#include "features/facets.hpp"
#include "features/region.hpp"

namespace epura::features {

/// Assigns facets without a region to the adjacent round region whose chords they are (is_chord): first those with
/// vertices on its surface, then those with vertices beside it, where its border was trimmed along an inexact curve,
/// and last those of any size that the region encloses.
void take_chords(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

}  // namespace epura::features
