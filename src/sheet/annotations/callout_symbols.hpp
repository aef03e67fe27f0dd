// SPDX-License-Identifier: Apache-2.0
// Symbols that stand beside a view: tolerance frames, datums, surface texture. ISO 1101, ISO 5459, ISO 21920-1; sizes
// of ISO 7083 and ISO 1302. Their lines are as wide as those of the lettering.
#pragma once

#include "annotations/callouts.hpp"
#include "scene/description.hpp"
#include "scene/geometric_tolerances.hpp"
#include "scene/surface_texture.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

/// A text of values with the decimal sign of the sheet, and letters instead of signs that its font lacks.
std::string with_own_signs(std::string text, const DimensionStyle& style);

/// Numbers of the zone have the decimal sign of the sheet.
Callout tolerance_frame(const scene::ToleranceFrame& frame, const DimensionStyle& style);

/// The frame with the letter of a datum. Its leader begins with a triangle on the line that it means.
Callout datum_frame(const scene::DatumFeature& datum, const DimensionStyle& style);

/// The circle of a datum target: its label below the line in the middle, the size of its area above. A size for which
/// there is no room stands beside the circle. ISO 5459, 7.2.
Callout target_symbol(const scene::DatumTarget& target, const DimensionStyle& style);

/// The symbol, which stands on the reference line of its leader.
Callout texture_symbol(const scene::SurfaceTexture& texture, const DimensionStyle& style);

/// Heights of a tolerance frame with its text above, of a datum frame or target, and of a texture symbol with so many
/// lines of text, in heights of capitals.
double height_of(const scene::ToleranceFrame& frame);
double height_of(const scene::DatumFeature& datum);
double height_of(const scene::DatumTarget& target);
double height_of(const scene::SurfaceTexture& texture);

}  // namespace epura::sheet
