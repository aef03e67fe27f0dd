// SPDX-License-Identifier: Apache-2.0
// The decimal place to which a text file's coordinates were rounded.
#pragma once

#include "mesh/soup.hpp"

namespace epura::mesh {

/// 10^-d when all coordinates are multiples of it, with 5 to 9 decimals, and so many need the last one that they look
/// rounded: a quarter of them, of a hundred points at least. Where not the decimals but the digits are alike (5 to 8,
/// as "%g" and "%e" write them), the last place of the largest coordinate. Otherwise 0: the coordinates mean what they
/// say.
double decimal_resolution(const Points& points);

}  // namespace epura::mesh
