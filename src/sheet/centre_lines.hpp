// SPDX-License-Identifier: Apache-2.0
// Centre lines: centre marks of circles, axes of round features, slots, pitch circles. ISO 128-2, type 04.1.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "scene/centred_features.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// A drawing that is in its place, and what is round in its models.
struct CentredView {
  const drawing::ViewDrawing& drawing;
  const scene::CentredFeatures& features;
  const BodyStyles& styles;
};

/// The layer VIEW/centre, narrow long-dashed dotted lines; without strokes in a central projection.
///
/// What is seen as a circle has a cross, its lines through the middle of a dash; the largest of concentric ones counts.
/// Holes on a pitch circle have that circle, and each a mark along its radius. A slot has one line through both of its
/// ends, and another across each. Seen from the side a feature has its axis, a slot that in its middle; seen otherwise
/// where two circles of it lie apart; rims on one line have one through all of them. All lines reach 3 mm beyond the
/// outline; overlapping ones are one line. Where a line of `drawn`, the view's other layers, coincides with them it
/// wins. What is smaller than 3 mm in diameter has no lines, nor has what a model without hidden lines does not show.
/// Throws OutOfTime.
Layer centre_lines(const CentredView& view, const LineWidths& widths, std::span<const Layer> drawn,
                   const Progress& progress = {});

}  // namespace epura::sheet
