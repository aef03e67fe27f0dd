// SPDX-License-Identifier: Apache-2.0
// Model files -> one world.
#pragma once

#include <memory>
#include <vector>

#include "base/progress.hpp"
#include "composition/requirement_ledger.hpp"
#include "importer/read_model.hpp"
#include "mesh/mesh.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// How models are read.
struct Reading {
  importer::ReadOptions options{};
  std::shared_ptr<KeptModels> kept{};  ///< null: every file is read, once
};

/// How far facets of imported surfaces are off on paper, mm, unless --max-error asks for finer ones.
inline constexpr double usual_facets = 0.02;

/// The precision that the drawings need so that facets of imported surfaces are off by no more than `facets` mm on
/// paper: from the given scales, otherwise from the paper on which the drawings must fit.
FacetPrecision precision_of(const scene::SceneDescription& scene, double facets = usual_facets);

/// With the precision of the options, or that which the drawings need.
Reading reading_of(const scene::SceneDescription& scene, const RunOptions& options, double facets = usual_facets);

/// Returns which part of the largest drawing, on the paper that it must fit, an error in mm is at least; 0 if no view
/// has such a paper.
double part_of_drawings(const scene::SceneDescription& scene, double error);

/// From the coordinates of a file to those of the world. The user's statements about a file take precedence over those
/// in the file.
Mat4 place_of(const scene::ModelDescription& model, const importer::ReadModel& read);

/// Whether any view draws edges without faces, which widen the box of the world then.
bool wants_wires(const scene::SceneDescription& scene);

struct ReadWorld {
  world::World world;
  std::vector<std::vector<importer::BodyPart>> parts{};  ///< of the bodies of each model
  std::vector<scene::ExplodeDescription> explosions{};   ///< of the scene, for bodies by their own names
  std::vector<FileRequirements> required{};              ///< of models that are drawn
  int without_unit = -1;  ///< the first model whose unit neither its file nor the user states; -1: none
};

/// Reads and positions the models; appends a report for each to `reports`. Reports repairs. Faces of parts are those
/// that the files declare.
ReadWorld read_models(const scene::SceneDescription& scene, const Reading& reading,
                      std::vector<mesh::MeshReport>& reports, const Messages& messages, Progress progress);

/// Reports if the sizes of that model, whose faces are recognised by now, are rather those of another unit than
/// millimetres.
void doubt_unit(const Messages& messages, const scene::SceneDescription& scene, const world::World& world,
                int without_unit);

}  // namespace epura::pipeline
