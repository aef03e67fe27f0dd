// SPDX-License-Identifier: Apache-2.0
// A drawing becomes layers of strokes with line types and widths. Lines: ISO 128-2.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "scene/choices.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Widths of lines on a sheet, mm: 0.7 and 0.35 from A1 on, 0.5 and 0.25 below.
struct LineWidths {
  double wide, narrow;
};
LineWidths line_widths(const Paper& paper);

/// What an edge is on a sheet, where its model has no role of its own. Hidden edges between smooth faces are nothing.
enum class EdgeLine { none, hidden, tangent, section, visible };

EdgeLine edge_line(EdgeKind kind, bool visible);

/// Of any but `none`.
LineStyle line_style(EdgeLine line, const LineWidths& widths);

/// How one model is drawn.
struct ModelStyle {
  LineRole line = LineRole::visible;
  HiddenLines hidden = HiddenLines::dashed;
};

/// Layers of a drawing that is in its place, to be painted in this order; `looks` are by model.
///   VIEW/hidden     hidden lines: narrow, dashed (type 02.1) or continuous
///   VIEW/neighbour, VIEW/narrow   visible lines of models with that role
///   VIEW/tangent    visible edges between smooth faces: narrow, continuous, short of the lines that they end at
///   VIEW/section    outlines of cut faces: wide, continuous
///   VIEW/visible    visible lines: wide, continuous
/// The first and the last one are there also when they are empty, unless no model has hidden lines. Dashed lines have
/// ink at their ends, at corners and where other lines cross them, unless too many do. Hidden edges between smooth
/// faces are left out.
std::vector<Layer> view_layers(const ViewDrawing& drawing, const LineWidths& widths,
                               const std::vector<ModelStyle>& looks, const Progress& progress = {});

}  // namespace epura
