// SPDX-License-Identifier: Apache-2.0
// Regions of facets that lie on cylinders, cones, spheres and tori: a surface through a few adjacent facets grows as
// far as vertices lie on it.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "surfaces/facets.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

/// What is searched for: among cylinders, there are cones where they fit better.
enum class Wanted { all_kinds, cylinders };

/// Starts with the first facets. Throws OutOfTime.
Regions find_round_regions(const Facets& facets, const Progress& progress, Wanted wanted = Wanted::all_kinds);

}  // namespace epura::surfaces
