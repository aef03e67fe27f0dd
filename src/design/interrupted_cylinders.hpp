// SPDX-License-Identifier: Apache-2.0
// Finds cylinders that slots, flats or teeth interrupt: drawings give their diameters all the same.
#pragma once

#include <vector>

#include "design/round_faces.hpp"

namespace epura::design {

/// The longest part of a circle, in degrees, that has a radius instead of a diameter.
inline constexpr double longest_arc = 200;

/// The parts of one cylinder; none of them is a full turn, but together they leave no larger gap than 360 degrees less
/// `longest_arc`.
struct InterruptedCylinder {
  std::vector<int> parts;  ///< indices of round faces
  double from, to;         ///< heights of its ends along the axis of the first part
};

/// Whether two faces are parts of one cylinder.
bool are_one_cylinder(const RoundFace& a, const RoundFace& b);

/// In the order of their first parts.
std::vector<InterruptedCylinder> find_interrupted_cylinders(const std::vector<RoundFace>& round);

}  // namespace epura::design
