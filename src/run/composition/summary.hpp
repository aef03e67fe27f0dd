// SPDX-License-Identifier: Apache-2.0
// What a finished sheet shows, in at most twelve sentences, for `epura describe` and for people who do not see it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "composition/finished_sheet.hpp"
#include "importer/assemble.hpp"
#include "scene/description.hpp"
#include "views/budget.hpp"
#include "views/view_plan.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

inline constexpr std::size_t most_sentences = 12;

/// The models of all sheets.
struct DescribedModels {
  const world::World& world;
  const scene::SceneDescription& scene;
  const std::vector<std::vector<importer::BodyPart>>& parts;  ///< of the bodies of each
  bool names_features;                                        ///< and says of which features lines are
};

/// Gives each sheet, with its views in `views`, its sentences in each language of phrases, its own first. Nothing is
/// said that neither the sheet nor the recognised faces prove. Without time to find features, there are none.
void describe(std::span<FinishedSheet> sheets, const std::vector<SheetOfViews>& views, const DescribedModels& models,
              const Budget& budget);

}  // namespace epura::pipeline
