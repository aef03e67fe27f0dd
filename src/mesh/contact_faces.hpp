// SPDX-License-Identifier: Apache-2.0
// Bodies of one file that touch in a face which both have, divided alike: such a face looks like a duplicate.
#pragma once

#include <optional>
#include <vector>

#include "mesh/faces.hpp"
#include "mesh/mesh.hpp"

namespace epura::mesh {

/// Numbers the bodies of a mesh as connected_parts does, with the faces of `twins` twice, and notes them as contacts.
/// Returns false and changes nothing if these do not divide the mesh into bodies that are closed where they touch:
/// copies of a body, and both sides of a sheet, are duplicates.
bool divide_at_contacts(Mesh& mesh, const std::vector<TwinFaces>& twins);

/// The body that touches a triangle of another one from behind, if there is one.
std::optional<int> body_behind(const Mesh& mesh, int triangle);

}  // namespace epura::mesh
