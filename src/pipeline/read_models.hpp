// SPDX-License-Identifier: Apache-2.0
// Model files -> one world.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "mesh/mesh.hpp"
#include "pipeline/messages.hpp"
#include "scene/description.hpp"
#include "scene/scene.hpp"

namespace epura::pipeline {

/// Reads and places the models; `reports` gets one more for each. Reports what was
/// repaired. The half-edge structures of its meshes are given up; edges and reports stay.
scene::World read_models(const std::vector<scene::ModelDescription>& models, std::vector<mesh::MeshReport>& reports,
                         const Messages& messages, Progress progress);

}  // namespace epura::pipeline
