// SPDX-License-Identifier: Apache-2.0
// Hatching of cut faces. ISO 128-3: narrow continuous lines at 45 degrees to the main outlines or axes, the same for
// all cut faces of one part, different for adjacent parts; thin sections are black.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/boxes.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// How the cut faces of one part are hatched in all views.
struct Hatching {
  int model, body;
  double angle;    ///< of the lines, degrees counterclockwise, 0 to 180
  double spacing;  ///< mm
};

/// The style of a body that is cut in a view, by number of its drawing, model and body.
using HatchRequest = std::function<HatchStyle(std::size_t drawing, int model, int body)>;

/// Returns a hatching for each part that is cut, sorted by model and body. Spacing grows with the largest cut face,
/// from 1 to 4 mm. Lines run neither along the part's own outlines nor perpendicular to them, and parts whose cut faces
/// are closer than 0.7 mm differ by angle or spacing. Angles and spacings that styles give are kept, and parts that
/// have them are chosen first. Throws OutOfTime.
std::vector<Hatching> choose_hatching(std::span<const drawing::ViewDrawing* const> drawings,
                                      const HatchRequest& wish = {}, const Progress& progress = {});

/// A view, the styles of its bodies, and the texts at which hatching is interrupted.
struct HatchedView {
  const drawing::ViewDrawing& drawing;
  const BodyStyles& styles;
  std::span<const TurnedBox> texts{};
};

/// Layer "VIEW/hatch". Hatching lines end at the outlines and beside texts; faces with an average width of less than 1
/// mm are filled, unless they have no pattern. Throws OutOfTime.
Layer hatch_layer(const HatchedView& view, std::span<const Hatching> hatching, const LineWidths& widths,
                  const Progress& progress = {});

}  // namespace epura::sheet
