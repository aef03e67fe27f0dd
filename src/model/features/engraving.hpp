// SPDX-License-Identifier: Apache-2.0
// Finds letters and numbers that are cut into a part, or stand out from it.
#pragma once

#include <vector>

#include "world/placed_part.hpp"

namespace epura::features {

/// Returns by face of a part: 1 for walls of letters, 0 for others. Letters are at least two recesses of one depth in
/// one plane, or bosses of one height, with walls perpendicular to it: a dozen on average, unlike rectangles and slots.
/// They are deep at most half their size, which is less than a fifth of that of the part; letters that touch are
/// longer, but no higher.
std::vector<char> walls_of_letters(const world::Placed& placed, const world::PlacedPart& part);

}  // namespace epura::features
