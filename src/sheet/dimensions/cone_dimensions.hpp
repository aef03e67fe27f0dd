// SPDX-License-Identifier: Apache-2.0
// Dimensions of cones: chamfers of shafts, and all others.
#pragma once

#include "sheet/dimensions/planning.hpp"

namespace epura::sheet {

/// One note for equal chamfers at the ends of shafts.
void add_chamfers(Planning& plan);

/// The angle of a cone with a rounded end; diameters and positions of other ends, as far as no cylinder and no step has
/// them.
void add_cones(Planning& plan);

}  // namespace epura::sheet
