// SPDX-License-Identifier: Apache-2.0
// Parts that lie askew in the world, and how they come to lie along its axes.
#pragma once

#include <string>

#include "world/world.hpp"

namespace epura::sheet {

/// The transform, in the words of scenes and of --transform ("rotate:z,30 rotate:x,-12.5"), after which more of the
/// area of a part lies along the axes of the world: faces whose normal or axis has the direction of one; faces that
/// mirror each other in a plane of two axes count half. Empty if none does better than the part as it lies, for several
/// models, and without recognised faces. Of all ways in which the part may lie so, the nearest one.
std::string transform_to_own_frame(const world::World& world);

}  // namespace epura::sheet
