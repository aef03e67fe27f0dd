// SPDX-License-Identifier: Apache-2.0
// Dimensions of cones: chamfers of shafts, and all others.
#pragma once

#include "sizes/planning.hpp"

namespace epura::sheet {

/// One note for equal chamfers at the ends of shafts.
Planned chamfer_dimensions(const Planning& plan);

/// The angle of a cone with a rounded end; diameters and positions of other ends, as far as no cylinder and no step has
/// them.
Planned cone_dimensions(const Planning& plan);

}  // namespace epura::sheet
