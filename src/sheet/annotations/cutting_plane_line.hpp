// SPDX-License-Identifier: Apache-2.0
// The cutting plane of a section, marked in a view that sees it edge-on. ISO 128-3.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cut/cutting_surface.hpp"
#include "drawing/view_drawing.hpp"
#include "projection/projection.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// Whether all planes and steps appear as lines in a parallel projection.
bool sees_edge_on(const projection::Projection& projection, const cut::CuttingSurface& surface);

/// How far the marks of a surface that is seen edge-on extend past the ink of a view: to either side, up and down, mm.
Vec2 cutting_plane_room(const projection::Projection& projection, const cut::CuttingSurface& surface,
                        const LineWidths& widths);

/// Layer "VIEW/cutting-plane": a narrow long-dashed dotted line (ISO 128-2, type 04.1) across the ink of `parent`, with
/// wide turns and wide ends (04.2) past its outline, arrows that point to them in the viewing direction of the section,
/// and its name next to them: at the ends of aligned sections, perpendicular to the plane there. An end along a step
/// has no arrow. Nothing if the view does not see the surface edge-on, and in central projections. The line may extend
/// `farther` past the outline, mm.
std::optional<Layer> cutting_plane_line(const drawing::ViewDrawing& parent, const cut::CuttingSurface& surface,
                                        const LineWidths& widths, double farther = 0);

/// Those of several surfaces: where the arrows or letters of one would be on the marks of another, its line is longer.
std::vector<std::optional<Layer>> cutting_plane_lines(const drawing::ViewDrawing& parent,
                                                      std::span<const cut::CuttingSurface> surfaces,
                                                      const LineWidths& widths);

/// Removes the parts of centre lines that lie on a cutting-plane line, which is of the same type.
void give_way(Layer& centre, const Layer& cutting_plane, const LineWidths& widths);

/// Adds the lines that divide a view of `surface` where it ends at a step, as half sections do: long-dashed dotted
/// narrow lines (04.1) past the ink of the view. They replace centre lines of the layer in the same places.
void add_dividing_lines(Layer& centre, const drawing::ViewDrawing& view, const cut::CuttingSurface& surface,
                        const LineWidths& widths);

}  // namespace epura::sheet
