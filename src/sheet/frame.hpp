// SPDX-License-Identifier: Apache-2.0
// The border of a sheet. ISO 5457.
#pragma once

#include <optional>

#include "scene/choices.hpp"
#include "sheet/furniture.hpp"
#include "sheet/paper.hpp"

namespace epura::sheet {

/// The paper with the margins that a frame needs, 20 mm on the left and 10 mm elsewhere, if it is not smaller than A5;
/// smaller sheets keep their margins.
Paper with_frame_margins(const Paper& paper);

/// Frame and marks. Full frames of sheets with other margins than those of ISO 5457 are plain. Grid fields are 50 mm
/// long, counted from the centring marks; what is left belongs to the fields at the corners. Sheets up to A4 have them
/// at the top and on the right only. Centring marks stop at the frame where they would reach into the title block.
Furniture frame(const Paper& paper, FrameKind kind, const std::optional<Rectangle>& title_block);

}  // namespace epura::sheet
