// SPDX-License-Identifier: Apache-2.0
// T-vertices: vertices on an open edge of a triangle, where triangles on its other side end. Boolean operations leave
// them where they divide the faces of one side only.
#pragma once

#include "base/progress.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/faces.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

/// Makes T-vertices corners of the triangles on whose edges they lie, within `width` and much closer than they are to
/// the ends, if parts of these edges then have triangles on both sides. An edge is divided only if the number of its
/// triangles is odd, and only the ends of such edges divide others. Of a triangle with a corner on its opposite side,
/// nothing may be left. Returns the number of edges divided. `table` has the edges of the triangles. Throws OutOfTime.
int insert_t_vertices(Faces& triangles, const Points& points, const EdgeTable& table, double width,
                      const Progress& progress);

}  // namespace epura::mesh
