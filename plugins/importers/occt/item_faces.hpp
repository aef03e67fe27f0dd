// SPDX-License-Identifier: Apache-2.0
// Faces of the model that belong to what a STEP file requires.
#pragma once

#include <STEPControl_Reader.hxx>
#include <vector>

#include "model.hpp"

namespace occt {

/// Sets the faces of requirements, and says in `missing` how many items stand for none. Edges stand for faces beside
/// them: of a size, a position, a datum or the like for the only cylinder; two that are apart, or an edge and a face,
/// for the only two planes or cylinders at a distance from each other. A place stands for the only face that it is on,
/// and so does a line beside solids, of a tolerance. A solid stands for all its faces, the only one for the part.
void find_faces(std::vector<Requirement>& requirements, const STEPControl_Reader& reader);

}  // namespace occt
