// SPDX-License-Identifier: Apache-2.0
// Dimensions of rectangular holes, pockets and bosses that are turned against the world.
#pragma once

#include "sizes/planning.hpp"

namespace epura::sheet {

/// Whether the size of the models along an axis follows from the sides and the angle of a part that is turned as a
/// whole.
bool is_over_turned_part(const Planning& plan, int axis);

/// Both widths, of equal ones once, the angle to the nearest axis of the world, and positions.
Planned prism_dimensions(const Planning& plan);

}  // namespace epura::sheet
