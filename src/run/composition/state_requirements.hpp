// SPDX-License-Identifier: Apache-2.0
// What model files require, as annotations of a scene, and the ledger of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "importer/requirements.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "surfaces/recognise.hpp"
#include "view/projected_scene.hpp"
#include "views/messages.hpp"
#include "views/shown_worlds.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// The requirements of a model, and what becomes of them.
struct FileRequirements {
  int model;
  std::vector<importer::ModelRequirement> all;        ///< of its file, then of the scene
  std::shared_ptr<const surfaces::PartFaces> part{};  ///< whose faces they name
  std::size_t by_scene = SIZE_MAX;                    ///< number of the first one of the scene, if there is one
  std::vector<report::RequirementRow> rows{};         ///< of each
};

/// Which of them the scene wants to be drawn.
Pmi wanted_requirements(const scene::SceneDescription& scene, const scene::ModelDescription& model);

/// Adds the rows that are missing, with why those that are not wanted or not read are not drawn. What the scene itself
/// states is wanted.
void begin_ledger(FileRequirements& file, const scene::SceneDescription& scene);

/// If all that is wanted is in inches, sheets without a unit have that.
void choose_unit(scene::SceneDescription& scene, const std::vector<FileRequirements>& files);

/// A sheet with its views.
struct SheetToState {
  const SheetOfViews& views;
  std::span<const view::ProjectedScene> seen;
  const ShownWorlds& worlds;
};

/// Adds dimensions, tolerance frames and datums to the scene for all that no other sheet shows, in orthographic views
/// without breaks. Sets the rows.
void state_requirements(scene::SceneDescription& scene, std::vector<FileRequirements>& files,
                        const SheetToState& sheet);

/// Says of what dimensions and callouts of the scene draw, by their `requirement`, that the sheet has no room for it.
void take_back(std::vector<FileRequirements>& files, const std::vector<std::string>& keys);

/// The number of each characteristic, by the `requirement` of what draws it.
std::map<std::string, int> numbered_characteristics(const std::vector<FileRequirements>& files);

/// Where on the sheet others are: the fields of its frame by their `requirement`.
void set_zones(std::vector<FileRequirements>& files, const std::vector<std::pair<std::string, std::string>>& zones);

/// All rows. Tells what is missing; if that is allowed, it is not wanted.
std::vector<report::RequirementRow> end_ledger(const std::vector<FileRequirements>& files, const Messages& messages,
                                               bool allow_missing);

}  // namespace epura::pipeline
