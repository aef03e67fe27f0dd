// SPDX-License-Identifier: Apache-2.0
// Model files -> one world.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "importer/read_model.hpp"
#include "mesh/mesh.hpp"
#include "pipeline/messages.hpp"
#include "pipeline/options.hpp"
#include "scene/description.hpp"
#include "scene/scene.hpp"

namespace epura::pipeline {

/// The precision that the drawings need so that no ink is off by more than RunOptions::max_error: from the given
/// scales, otherwise from the paper on which the drawings must fit.
importer::ReadOptions read_options(const scene::SceneDescription& scene, const RunOptions& options,
                                   double fineness = 1);

/// Reads and positions the models; appends a report for each to `reports`. Reports repairs. Faces of parts are those
/// that the files declare.
scene::World read_models(const scene::SceneDescription& scene, const importer::ReadOptions& options,
                         std::vector<mesh::MeshReport>& reports, const Messages& messages, Progress progress);

}  // namespace epura::pipeline
