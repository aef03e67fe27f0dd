// SPDX-License-Identifier: Apache-2.0
// Mass and centre of gravity of the models, for title blocks and views.
#pragma once

#include <string>

#include "scene/description.hpp"
#include "views/messages.hpp"
#include "world/mass.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Of all bodies. Throws Error{input} with `where` as the location for bodies that are not closed, and, if a mass is
/// wanted, for bodies without a density.
world::MassProperties mass_of(const world::World& world, const scene::SceneDescription& scene, bool wants_mass,
                              const std::string& where);

/// Replaces `auto` as the mass in a title block.
void complete_mass(scene::SceneDescription& scene, const world::World& world, const Messages& messages);

}  // namespace epura::pipeline
