// SPDX-License-Identifier: Apache-2.0
// Centre lines: crosses on circles, axes of what is round. ISO 128-2, type 04.1.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "scene/placed_circles.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// A drawing that is in its place, and the circles of its models.
struct CentredView {
  const drawing::ViewDrawing& drawing;
  std::span<const scene::PlacedCircle> circles;
  const std::vector<ModelStyle>& styles;  ///< by model
};

/// The layer VIEW/centre, narrow long-dashed dotted lines; without strokes in a central projection.
///
/// A circle that is seen as a circle has a cross, its lines through the middle of a dash; the largest of concentric
/// ones counts. An axis is drawn where a circle is seen edge-on, and through two or more circles on it however they are
/// seen: one line through all of them. All lines reach 3 mm beyond the outline; overlapping ones are one line. Where a
/// line of `drawn`, the view's other layers, coincides with them it wins. Circles below 1 mm in diameter have no
/// lines, nor have those that a model without hidden lines does not show. Throws OutOfTime.
Layer centre_lines(const CentredView& view, const LineWidths& widths, std::span<const Layer> drawn,
                   const Progress& progress = {});

}  // namespace epura::sheet
