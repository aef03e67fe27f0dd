// SPDX-License-Identifier: Apache-2.0
// Dimensions of fillets and rounded corners, rounded edges, and spheres.
#pragma once

#include <span>

#include "sheet/dimensions/planning.hpp"

namespace epura::sheet {

/// Places of the centres of round ends and of open channels.
Planned arc_positions(const Planning& plan);

/// Places of the centres of spheres.
Planned ball_positions(const Planning& plan);

/// Equal radii have one note, whatever their axes: the view that shows most of them has it.
Planned arc_dimensions(const Planning& plan);

/// Rounded edges and spheres whose radius is not that of one of the dimensions so far, to which they belong.
Planned round_dimensions(const Planning& plan, std::span<const scene::DimensionDescription> so_far);
Planned ball_dimensions(const Planning& plan, std::span<const scene::DimensionDescription> so_far);

}  // namespace epura::sheet
