// SPDX-License-Identifier: Apache-2.0
// What the models tell of the lines on a sheet: lengths in space, faces, bodies, and depth.
#pragma once

#include "drawing/view_drawing.hpp"
#include "sheet/sheet.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Adds the facts of all strokes of a view that draw edges of a file; `world` is the one that the view shows.
void add_line_facts(sheet::Sheet& sheet, const drawing::ViewDrawing& drawing, const world::World& world);

}  // namespace epura::pipeline
