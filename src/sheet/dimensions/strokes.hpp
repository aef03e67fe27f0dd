// SPDX-License-Identifier: Apache-2.0
// The strokes of placed dimensions as they are drawn: each line once, and none through letters.
#pragma once

#include <vector>

#include "dimensions/conflicts.hpp"
#include "sheet/boxes.hpp"

namespace epura::sheet {

/// Of strokes along one another, as extension lines from one place, one is drawn: no pen follows a line twice.
void draw_once(PlacedDimensions& placed);

/// Straight lines make room for letters: no line goes through lettering (ISO 128-2).
void interrupt_at(const std::vector<TurnedBox>& letters, PlacedDimensions& placed);

}  // namespace epura::sheet
