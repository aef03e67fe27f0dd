// SPDX-License-Identifier: Apache-2.0
// Arcs and matrices of IGES that Open CASCADE 7.6.3 would read as others (findings/occt-iges-conics.sh,
// findings/occt-iges-mirrored-arcs.sh and findings/occt-iges-nested-matrices.sh).
#pragma once

#include <IGESData_IGESModel.hxx>

namespace occt {

/// Lets each matrix (124) that refers to others be the product of them, which Open CASCADE leaves out. Throws
/// std::runtime_error if matrices refer to one another.
void combine_matrices(const Handle(IGESData_IGESModel) & model);

/// Writes conic arcs (104) whose axis is not along their x axis, and arcs (100, 104) that a matrix mirrors, in
/// coordinates in which Open CASCADE reads them right, after combine_matrices: each has the same points, from the same
/// start to the same end.
void align_arcs(const Handle(IGESData_IGESModel) & model);

}  // namespace occt
