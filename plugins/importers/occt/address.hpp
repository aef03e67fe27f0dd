// SPDX-License-Identifier: Apache-2.0
// Shapes in the memory of this process, as modules for Python hold them.
#pragma once

#include <TopoDS_Shape.hxx>

namespace occt {

/// A copy of the TopoDS_Shape at the address, whose geometry it shares, so that facets are made in the copy alone.
/// Throws std::runtime_error if there is no memory, no shape, or one of another library of Open CASCADE, whose shapes
/// have another layout; only a shape that no longer exists, in memory that has not been used since, is taken for one.
TopoDS_Shape shape_at(const void* address);

}  // namespace occt
