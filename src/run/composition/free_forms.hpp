// SPDX-License-Identifier: Apache-2.0
// Faces of free form: no dimension gives their sizes, so a drawing refers to the model for them. ISO 16792.
#pragma once

#include <string>
#include <vector>

#include "scene/description.hpp"
#include "views/messages.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Adds a general note to the first sheet which says that free forms are those of the model, where features are to be
/// dimensioned and nothing else tells it. Returns whether there is one.
bool refer_to_models(scene::SceneDescription& scene, const world::World& world);

/// Warns of models without any recognised face, to which such a note refers as a whole.
void warn_of_unrecognised(const Messages& messages, const scene::SceneDescription& scene, const world::World& world);

/// A sentence for each model with free forms that no profile tolerance of a surface (ISO 1101) refers to: one with a
/// leader is for its face, one without for all. If they are `noted`, only for models whose faces are not looked for.
std::vector<std::string> free_forms_without_tolerance(const scene::SceneDescription& scene, const world::World& world,
                                                      bool noted);

}  // namespace epura::pipeline
