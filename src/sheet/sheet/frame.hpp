// SPDX-License-Identifier: Apache-2.0
// The border of a sheet. ISO 5457; of sheets in inches, ASME Y14.1.
#pragma once

#include <optional>
#include <string>

#include "scene/choices.hpp"
#include "sheet/furniture.hpp"
#include "sheet/paper.hpp"

namespace epura::sheet {

/// Of ISO 5457, mm: on the left, and elsewhere.
inline constexpr double binding_margin = 20, plain_margin = 10;

/// The paper with the margins that a frame needs (20 mm on the left, 10 mm elsewhere) if it is at least as large as A5;
/// smaller sheets, and those of ASME Y14.1, keep their margins.
Paper with_frame_margins(const Paper& paper);

/// Frame and marks. A full frame becomes a plain one on sheets whose margins differ from those of ISO 5457. Grid fields
/// are 50 mm long, counted from the centring marks; the remainder goes to the fields at the corners. Sheets up to A4
/// have fields at the top and on the right only. Centring marks stop at the frame where they would reach into the title
/// block. The zones of ASME Y14.1 divide the sheet into equal fields, numbered from its lower right corner; size A has
/// none.
Furniture frame(const Paper& paper, FrameKind kind, const std::optional<Rectangle>& title_block);

/// The field of a frame in which a point of the paper lies, as "B4" (of ASME Y14.1 likewise); of a point beyond the
/// frame, the nearest field. Empty where the frame has none.
std::string zone_at(const Paper& paper, FrameKind kind, const Vec2& point);

}  // namespace epura::sheet
