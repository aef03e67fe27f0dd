// SPDX-License-Identifier: Apache-2.0
// Facets that are pieces of a round face although they face elsewhere.
#pragma once

#include <vector>

#include "surfaces/facets.hpp"
#include "surfaces/region.hpp"

namespace epura::surfaces {

/// Assigns facets without a region to the adjacent round region whose chords they are (is_chord): first those with
/// vertices on its surface, then those with vertices beside it, where its border was trimmed along an inexact curve,
/// and last those of any size that the region encloses.
Regions take_chords(const Facets& facets, Regions found);

/// Whether all facets of a region are chords of another one's surface (is_chord), to within the allowance of that one
/// or a given one.
bool are_chords(const Facets& facets, const Region& some, const Region& of);
bool are_chords(const Facets& facets, const Region& some, const Region& of, double allowance);

/// Whether the facets of a region may be what a cut left of some of a sphere: nowhere above it, and no deeper below it
/// than whole ones.
bool are_left_of_sphere(const Facets& facets, const Region& some, const Region& of);

/// Where several round faces meet, vertices lie off each of them by a part of the sagitta, so that a facet between them
/// may be left. Returns the one of these faces that it is nearest to; -1 if it may be a flat of the part: a flat with
/// so few corners has a straight side that is no chord, a sharp edge, or lies farther away.
int region_around(const Facets& facets, int facet, const std::vector<int>& region_of,
                  const std::vector<Region>& regions);

}  // namespace epura::surfaces
