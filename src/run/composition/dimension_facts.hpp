// SPDX-License-Identifier: Apache-2.0
// What the models tell of the dimensions on sheets: the faces that they measure, and ids that stay.
#pragma once

#include <span>

#include "composition/finished_sheet.hpp"
#include "scene/description.hpp"
#include "sizes/coverage.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Gives dimensions on the sheets their faces, their tolerances, and ids: their names in the scene, or what they
/// measure, as "linear:x:face 1-4", with "#2" for the second one of the same. `views` are those of all sheets, with the
/// dimensions that are drawn.
void add_dimension_facts(std::span<FinishedSheet> sheets, std::span<const sheet::DimensionsInView> views,
                         const world::World& world, const scene::SceneDescription& scene);

}  // namespace epura::pipeline
