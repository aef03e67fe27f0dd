// SPDX-License-Identifier: Apache-2.0
// Dimensions of a view. ISO 129-1.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "scene/description.hpp"
#include "scene/scene.hpp"
#include "sheet/dimensions/marks.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// A view in its place, and what is to be measured in it.
struct DimensionedView {
  const scene::World& world;
  const drawing::ViewDrawing& drawing;
  std::span<const scene::DimensionDescription> dimensions;
};

/// Items on the sheet near a view.
struct Neighbours {
  std::optional<Rectangle> paper{};  ///< limits for everything
  std::vector<TurnedBox> boxes{};    ///< of other views, lettering, marks ...
};

/// Layer "VIEW/dimensions" of a drawing that is in its place: narrow lines, filled arrows, and texts. Values are the
/// true measures in the world. Dimensions are outside the outline, small ones inside large ones, and keep out of each
/// other's way and that of their neighbours where they can; an offset is obeyed.
/// Each has one text; those that do not fit into the time are omitted.
/// Throws Error{input}: see sheet/dimensions/anchors.hpp and measure.hpp; and for characters that the font lacks.
Layer dimension_layer(const DimensionedView& view, const DimensionStyle& style, const Neighbours& neighbours = {},
                      const Progress& progress = {});

/// Whether all of it lies on a paper of this size, mm.
bool on_paper(const Layer& dimensions, const Vec2& size);

}  // namespace epura::sheet
