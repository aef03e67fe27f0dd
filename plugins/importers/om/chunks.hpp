// SPDX-License-Identifier: Apache-2.0
// The chunks of an OM file. OpenMesh asserts what the header of a chunk says, or believes it, depending on how it was
// built; here it is tested.
#pragma once

#include <string>
#include <string_view>

namespace om {

/// The file with those chunks alone that have places of vertices, half-edges, faces, and which faces are deleted.
/// Throws std::runtime_error that says what is wrong with a chunk, of whatever kind.
std::string needed_chunks(std::string_view file);

}  // namespace om
