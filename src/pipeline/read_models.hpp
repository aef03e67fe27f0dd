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

/// The precision that the drawings need, so that no ink is off by more than RunOptions::max_error: from the scales that
/// are given, otherwise from the paper that the drawings will fit on.
importer::ReadOptions read_options(const scene::SceneDescription& scene, const RunOptions& options);

/// Reads and places the models; `reports` gets one more for each. Reports what was repaired. Faces of parts are those
/// that files declare.
scene::World read_models(const scene::SceneDescription& scene, const importer::ReadOptions& options,
                         std::vector<mesh::MeshReport>& reports, const Messages& messages, Progress progress);

}  // namespace epura::pipeline
