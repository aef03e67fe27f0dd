// SPDX-License-Identifier: Apache-2.0
// What a file requires of its part, on the faces of the model.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "importer/assemble.hpp"
#include "mesh/mesh.hpp"
#include "surfaces/recognise.hpp"

namespace epura::importer {

struct ModelRequirement : StatedRequirement {
  std::vector<int> faces{};  ///< of the model's part, in ascending order
};

/// `part` are the faces that the assembled part became on the mesh; null if the file has none.
std::vector<ModelRequirement> requirements_of(const Document& document, const Assembled& assembled,
                                              const mesh::Mesh& mesh, const surfaces::PartFaces* part);

/// "12 dimensions, 6 geometric tolerances and 3 datums"; empty if there are none.
std::string counted_requirements(const std::vector<ModelRequirement>& requirements);

/// Whether an inspection measures requirements of this kind.
bool is_measured(RequirementKind kind);

/// How many there are of this kind.
std::size_t count_of(const std::vector<ModelRequirement>& requirements, RequirementKind kind);

}  // namespace epura::importer
