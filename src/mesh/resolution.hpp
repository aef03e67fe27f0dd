// SPDX-License-Identifier: Apache-2.0
// Detects the decimal place to which the coordinates of a text file were rounded.
#pragma once

#include "mesh/soup.hpp"

namespace epura::mesh {

/// Returns 10^-d if all coordinates are multiples of it, with d from 5 to 9, and so many need the last decimal that
/// they appear rounded: a quarter of them, with a hundred points at least. If not the decimals but the significant
/// digits are equal in number (5 to 8, as "%g" and "%e" write them), returns the last place of the largest coordinate.
/// Otherwise 0: the coordinates are taken as exact.
double decimal_resolution(const Points& points);

}  // namespace epura::mesh
