// SPDX-License-Identifier: Apache-2.0
// Parts that lie askew in the world, and how they come to lie along its axes.
#pragma once

#include <optional>
#include <string>

#include "world/world.hpp"

namespace epura::sheet {

/// The turn after which more of the area of a part lies along the axes of the world: faces whose normal or axis has the
/// direction of one; faces that mirror each other in a plane of two axes count half. Nothing if faces lie along two of
/// the axes already, as the rim of a plate with slanted slots; if none does better than the part as it lies, by two
/// faces or more: one flank tells no frame; if less than half of the area lies so, as in an assembly with parts that
/// lie in many ways; for several models, and without recognised faces. Of all ways in which the part may lie so, the
/// nearest one.
std::optional<Mat4> turn_to_own_frame(const world::World& world);

/// In the words of scenes and of --transform: "rotate:z,30 rotate:x,-12.5".
std::string words_of_turn(const Mat4& turn);

}  // namespace epura::sheet
