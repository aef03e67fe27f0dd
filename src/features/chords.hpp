// SPDX-License-Identifier: Apache-2.0
// Facets that are pieces of a round face though they face elsewhere.
#pragma once

#include <vector>

#include "features/facets.hpp"
#include "features/region.hpp"

namespace epura::features {

/// Gives facets without a region to the round one beside them whose chords they are, see is_chord: first those with
/// vertices on its surface, then those with vertices beside it, where its border was trimmed along a curve that is not
/// exact.
void take_chords(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions);

}  // namespace epura::features
