// SPDX-License-Identifier: Apache-2.0
// The border for coordinates of models, wherever they come from: files, transforms, moves of bodies, programs.
#pragma once

#include "world/world.hpp"

namespace epura::world {

/// Throws Error{input} that names the model if a coordinate is beyond `largest_number`.
void expect_usable(const World& world);

}  // namespace epura::world
