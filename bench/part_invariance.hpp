// SPDX-License-Identifier: Apache-2.0
// Whether drawings of a part depend on its tessellation.
#pragma once

#include <vector>

#include "apart.hpp"
#include "part_drawing.hpp"
#include "part_geometry.hpp"

namespace epura::bench {

/// Draws each part from tessellations of several finenesses, and from gmsh's where it is installed. Prints the numbers
/// of strokes, and the ink that differs from that of the usual fineness by more than the sum of the sagittas of
/// both. Returns whether there was any result.
bool compare_tessellations(const std::vector<Part>& parts, Surfaces surfaces, const Limits& limits);

}  // namespace epura::bench
