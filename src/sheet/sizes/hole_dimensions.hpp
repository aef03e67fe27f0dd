// SPDX-License-Identifier: Apache-2.0
// Dimensions of holes, of holes about an axis, and of pitch circles; or the rows of tables instead of these.
#pragma once

#include "sizes/planning.hpp"

namespace epura::sheet {

/// One note, the angles and the heights of holes that lead to the axis of a round part.
Planned radial_hole_dimensions(const Planning& plan);

/// Of all other holes: notes and positions, or rows of a table if one is wanted.
Planned hole_dimensions(const Planning& plan);

/// Of a crowded assembly, none: they are for drawings of groups of parts.
Planned holes_left_out(const Planning& plan);

/// None if a table of holes is wanted, which has their places.
Planned pitch_circle_dimensions(const Planning& plan);

}  // namespace epura::sheet
