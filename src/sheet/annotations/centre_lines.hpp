// SPDX-License-Identifier: Apache-2.0
// Centre lines: centre marks of circles, axes of round features, slots, pitch circles. ISO 128-2, type 04.1.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/view_drawing.hpp"
#include "features/centred_features.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// A drawing in its final position, and the round features of its models.
struct CentredView {
  const drawing::ViewDrawing& drawing;
  const features::CentredFeatures& features;
  const BodyStyles& styles;
};

/// The layer VIEW/centre, narrow long-dashed dotted lines; without strokes in a central projection.
///
/// A feature seen as a circle has a cross, with the lines crossing in the middle of a dash; of concentric circles, the
/// largest counts. Holes on a pitch circle have that circle, and each hole a mark along its radius. A slot has one line
/// through both of its ends, and another across each end, an arm one from axis to axis. Seen from the side, a feature
/// has its axis, and a slot an axis in its middle; in other directions, a feature has its axis if two of its circles
/// lie apart. Rims on one line have one common axis. All lines extend 3 mm beyond the outline; overlapping ones are
/// merged. Where a line of `drawn`, the view's other layers, coincides with them, it takes precedence. Features with a
/// diameter of less than 3 mm have no lines, nor have features that a model without hidden lines does not show. There,
/// bores and slots that are seen obliquely have their axes only through ends of which a quarter of the rim is seen, 3
/// mm beyond what is seen; shafts and other features that are seen from outside, only where lines of theirs are seen on
/// both sides of the axis, or on one if it is parallel to the paper. Throws OutOfTime.
Layer centre_lines(const CentredView& view, const LineWidths& widths, std::span<const Layer> drawn,
                   const Progress& progress = {});

}  // namespace epura::sheet
