// SPDX-License-Identifier: Apache-2.0
// What model files require, as annotations of a scene.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "composition/requirement_ledger.hpp"
#include "scene/description.hpp"
#include "view/projected_scene.hpp"
#include "views/shown_worlds.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// Sheets without a standard have those that the files name of what is wanted; sheets without a unit have inches, if
/// all that is wanted is in inches.
void choose_notation(scene::SceneDescription& scene, const std::vector<FileRequirements>& files);

/// A sheet with its views.
struct SheetToState {
  const SheetOfViews& views;
  std::span<const view::ProjectedScene> seen;
  const ShownWorlds& worlds;
};

/// Adds dimensions, tolerance frames and datums to the scene for all that no other sheet shows, in orthographic views
/// without breaks. Sets the rows. Returns the views, as in --projection, that would show what no view of the sheet
/// shows.
std::vector<std::string> state_requirements(scene::SceneDescription& scene, std::vector<FileRequirements>& files,
                                            const SheetToState& sheet);

}  // namespace epura::pipeline
