// SPDX-License-Identifier: Apache-2.0
// The symbol for first-angle or third-angle projection. ISO 5456-2.
#pragma once

#include "scene/choices.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

/// A truncated cone, and next to it the view of its small end: two circles. `height` is that of the lettering around
/// it: the diameter of the small end; the large end is twice that, as is the cone's length. The small end points to the
/// left: away from the circles in first angle projection, towards them in third. Outlines are medium, centre lines
/// narrow. `centre` is the middle of the whole symbol.
Furniture projection_symbol(ProjectionAngle angle, double height, const Vec2& centre);

/// Of the symbol with its centre lines, mm.
Vec2 projection_symbol_size(double height);

}  // namespace epura::sheet
