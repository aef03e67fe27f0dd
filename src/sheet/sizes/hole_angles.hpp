// SPDX-License-Identifier: Apache-2.0
// Angles of holes around an axis. Centre lines show their zero; evenly spaced holes have one angle for all (ISO 129-1).
#pragma once

#include <cstddef>
#include <vector>

#include "sizes/anchors.hpp"
#include "sizes/hole_directions.hpp"
#include "sizes/planning.hpp"

namespace epura::sheet {

/// The angles that are needed, between centre lines and holes, and the step of evenly spaced radial ones.
std::vector<scene::DimensionDescription> angles_of(const Planning& plan, const HoleDirections& around, bool with_step);

/// Whether an angle about the same axis has a leg in the direction of a hole, or of one that is alike if it counts
/// several.
bool gives_direction(const AnchoredDimension& dimension, const HoleDirections& around, std::size_t number);

}  // namespace epura::sheet
