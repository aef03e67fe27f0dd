// SPDX-License-Identifier: Apache-2.0
// The cutting plane of a section, marked in a view that sees it edge-on. ISO 128-3.
#pragma once

#include <optional>

#include "drawing/drawing.hpp"
#include "scene/cutting_plane.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// Whether the plane appears as a line in a parallel projection.
bool sees_edge_on(const projection::Projection& projection, const scene::CuttingPlane& plane);

/// How far the marks of a plane that is seen edge-on extend past the ink of a view: to either side, up and down, mm.
Vec2 cutting_plane_room(const projection::Projection& projection, const scene::CuttingPlane& plane,
                        const LineWidths& widths);

/// Layer "VIEW/cutting-plane": a narrow long-dashed dotted line (ISO 128-2, type 04.1) across the ink of `parent`, with
/// wide ends (04.2) past its outline, arrows that point to them in the viewing direction of the section, and its name
/// next to them. Nothing if the view does not see the plane edge-on, and in central projections.
std::optional<Layer> cutting_plane_line(const drawing::ViewDrawing& parent, const scene::CuttingPlane& plane,
                                        const LineWidths& widths);

}  // namespace epura::sheet
