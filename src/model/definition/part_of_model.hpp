// SPDX-License-Identifier: Apache-2.0
// The faces of a model, and where they meet, as the accountant sees them.
#pragma once

#include <optional>

#include "definition/part.hpp"
#include "world/world.hpp"

namespace epura::definition {

/// In the world; faces are numbered as those of the model. Nothing if no faces are recognised, or if the model is
/// scaled unequally. A border has some points along it.
std::optional<Part> part_of_model(const world::World& world, int model);

}  // namespace epura::definition
