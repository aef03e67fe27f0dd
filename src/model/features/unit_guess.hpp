// SPDX-License-Identifier: Apache-2.0
// The unit of a file that states none, guessed from the sizes of the part.
#pragma once

#include <epura/choices.hpp>
#include <optional>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "surfaces/recognise.hpp"

namespace epura::features {

/// The box of what is drawn of a mesh: faces and wires; in the unit of the file.
Box box_of(const mesh::Mesh& mesh);

/// The unit in which most diameters are round and the part has a plausible size. Inches come before metres, in which
/// every thousandth is round; without round diameters, a plausible size means millimetres. Nothing if neither tells.
std::optional<Unit> guess_unit(const Box& box, const surfaces::PartFaces& part);

}  // namespace epura::features
