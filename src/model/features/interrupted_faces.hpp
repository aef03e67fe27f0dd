// SPDX-License-Identifier: Apache-2.0
// Finds cylinders and tori that slots, flats or teeth interrupt: drawings give their diameters all the same.
#pragma once

#include <vector>

#include "features/round_faces.hpp"

namespace epura::features {

/// The parts of one cylinder or torus; none of them is a full turn, but together they leave no larger gap than 360
/// degrees less `longest_arc`.
struct InterruptedFace {
  std::vector<int> parts;  ///< indices of round faces
  double from, to;         ///< heights of its ends along the axis of the first part, from its origin
};

/// Whether two faces are parts of one cylinder, cone or torus.
bool are_one_turn(const RoundFace& a, const RoundFace& b);

/// Of one kind, in the order of their first parts.
std::vector<InterruptedFace> find_interrupted(const std::vector<RoundFace>& round, surfaces::SurfaceKind kind);

}  // namespace epura::features
