// SPDX-License-Identifier: Apache-2.0
// Holes on a circle around a round feature.
#pragma once

#include <span>
#include <vector>

#include "scene/centred_features.hpp"

namespace epura::scene {

/// What decides whether a round feature is one of several equal holes.
struct HoleSize {
  int feature;                ///< its place among the round features
  std::vector<double> radii;  ///< of its whole bores, ascending; none for shafts
};

/// Three or more equal holes in equal distance from the axis of another feature, all axes parallel. Corners of a
/// rectangle that is not square lie on no pitch circle, although their distances from its middle are equal: they are
/// dimensioned along its sides. A hole lies on one pitch circle at most, that with most holes. Throws OutOfTime.
std::vector<PitchCircle> find_pitch_circles(std::span<const RoundFeature> features, std::span<const HoleSize> sizes,
                                            const Progress& progress);

}  // namespace epura::scene
