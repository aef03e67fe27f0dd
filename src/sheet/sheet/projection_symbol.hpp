// SPDX-License-Identifier: Apache-2.0
// The symbol for first-angle or third-angle projection. ISO 5456-2.
#pragma once

#include "scene/choices.hpp"
#include "sheet/furniture.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// A truncated cone, and next to it the view of its small end: two circles. `height` is the height of the surrounding
/// lettering and the diameter of the small end; the large end has twice that diameter, and the cone that length. The
/// small end points to the left: away from the circles in first-angle projection, towards them in third-angle
/// projection. Outlines are medium, centre lines narrow. `centre` is the middle of the whole symbol.
Furniture projection_symbol(ProjectionAngle angle, double height, const Vec2& centre);

/// Size of the symbol with its centre lines, mm.
Vec2 projection_symbol_size(double height);

void add_gravity_symbol(Layer& layer, const Vec2& centre, double radius);

}  // namespace epura::sheet
