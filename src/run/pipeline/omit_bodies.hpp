// SPDX-License-Identifier: Apache-2.0
// Models without some of their bodies.
#pragma once

#include <vector>

#include "importer/read_model.hpp"

namespace epura::pipeline {

/// Removes the triangles of the bodies that are marked. Vertices, faces of the file and bodies keep their numbers, and
/// the report remains that of the file. Lines that bound no face belong to no body and stay.
void omit_bodies(importer::ReadModel& model, const std::vector<bool>& omitted);

}  // namespace epura::pipeline
