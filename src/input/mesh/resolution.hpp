// SPDX-License-Identifier: Apache-2.0
// Detects to what the coordinates of a file were rounded.
#pragma once

#include "mesh/soup.hpp"

namespace epura::mesh {

/// By how many roundings of a coordinate a vertex may lie off its place: three coordinates are rounded, and those of
/// its neighbours; those computed in different ways differ by more than one; a cut moves along with its edges.
inline constexpr double roundings = 4;

/// Returns the distance between neighbouring values of coordinates if these appear rounded, the widest of:
/// 10^-d, with d from 2 to 12, if all coordinates are multiples of it and enough of them need the last decimal;
/// the last place of the largest coordinate, if all have the same number of significant digits (5 to 8, as "%g" and
/// "%e" write them);
/// the step of a lattice (resolution.cpp), unless a designer would choose it.
/// Otherwise 0: the coordinates are taken as exact. `are_floats`: they are known to 32 bits.
double resolution_of(const Points& points, bool are_floats);

}  // namespace epura::mesh
