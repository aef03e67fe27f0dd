// SPDX-License-Identifier: Apache-2.0
// Dimensions of shafts, bosses and bores that are no holes, and of slots.
#pragma once

#include "sizes/planning.hpp"

namespace epura::sheet {

/// Diameters, in a view across their axes if it shows the outline, useful lengths of threads, and positions; without
/// those that are an overall dimension.
Planned cylinder_dimensions(const Planning& plan);

/// Radii, lengths between the centres of their ends, and positions.
Planned slot_dimensions(const Planning& plan);

}  // namespace epura::sheet
