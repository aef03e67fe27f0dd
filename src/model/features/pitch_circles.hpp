// SPDX-License-Identifier: Apache-2.0
// Finds holes on a circle around a round feature.
#pragma once

#include <span>
#include <vector>

#include "features/centred_features.hpp"

namespace epura::features {

/// The sizes by which equal holes are recognised.
struct HoleSize {
  int feature;                ///< index of the round feature
  std::vector<double> radii;  ///< radii of its whole bores, ascending; none for shafts
};

/// Finds three or more equal holes at equal distances from the axis of another feature, with all axes parallel. The
/// corners of a rectangle that is not square form no pitch circle, although their distances from its centre are equal:
/// such holes are dimensioned along the sides. A hole lies on at most one pitch circle, the one with the most holes.
/// Throws OutOfTime.
std::vector<PitchCircle> find_pitch_circles(std::span<const CentredRound> features, std::span<const HoleSize> sizes,
                                            const Progress& progress);

}  // namespace epura::features
