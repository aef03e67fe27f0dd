// Dimensions of a view. ISO 129-1.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "scene/description.hpp"
#include "scene/scene.hpp"
#include "sheet/lettering.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Layer "VIEW/dimensions" of a drawing that is in its place: narrow lines `line_width` mm wide, filled arrows, and
/// texts with capitals `text_height` mm high. Values are the true measures in the world. Dimensions stand outside the
/// outline, small ones inside large ones, and keep out of each other's way where they can; an offset is obeyed.
/// Throws Error{input}: see sheet/dimensions/anchors.hpp and measure.hpp; and for characters that the font lacks.
Layer dimension_layer(const World& world, const Drawing& drawing, std::span<const DimensionDescription> dimensions,
                      const Lettering& lettering, double line_width, double text_height = 3.5);

/// Whether all of it lies on a paper of this size, mm.
bool on_paper(const Layer& dimensions, const Vec2& size);

}  // namespace epura
