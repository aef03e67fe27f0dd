// SPDX-License-Identifier: Apache-2.0
// Notes that give sizes as dimensions do, with a leader to something round or of all of a kind.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sheet/notation.hpp"
#include "sizes/dimensions_in_view.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// The views with a diameter or radius more for each such note whose size is that of the face there, and for each pitch
/// circle that a note or dimension gives: those of all fillets or holes, `general`, in the first view.
std::vector<DimensionsInView> with_noted_sizes(std::span<const DimensionsInView> views,
                                               std::span<const std::string> general, const world::World& world,
                                               const Notation& notation);

}  // namespace epura::sheet
