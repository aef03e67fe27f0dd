// SPDX-License-Identifier: Apache-2.0
// The symbol of a centre of gravity: a circle of which two opposite quarters are filled.
#pragma once

#include "sheet/sheet.hpp"

namespace epura::sheet {

void add_gravity_symbol(Layer& layer, const Vec2& centre, double radius);

}  // namespace epura::sheet
