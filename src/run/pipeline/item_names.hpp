// SPDX-License-Identifier: Apache-2.0
// Patterns for bodies that are written with names of the parts list.
#pragma once

#include <span>
#include <vector>

#include "pipeline/kept_models.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Styles and moves of a scene, in their order.
struct BodyPatterns {
  std::vector<scene::StyleDescription> styles;
  std::vector<scene::ExplodeDescription> explosions;
};

/// Those of the scene. One whose pattern is the name of no body and no model, but of an item of the parts list, is
/// replaced by one for each name of the bodies of the item; bodies without names get that of the item. `places` of the
/// models in the world. Warns of styles for nothing, with the names that there are.
BodyPatterns with_item_names(const scene::SceneDescription& scene, std::vector<KeptModel>& models,
                             std::span<const Mat4> places, const Messages& messages);

}  // namespace epura::pipeline
