// SPDX-License-Identifier: Apache-2.0
// How the faces of a body meet at its edges.
#pragma once

#include <TopoDS_Edge.hxx>
#include <vector>

#include "body_mesh.hpp"

namespace occt {

struct Joint {
  TopoDS_Edge edge;
  Along along;
  bool is_tangent;
  double angle;  ///< degrees between the outward normals: nearly the maximum along the edge; NaN: unknown
};

/// Edges between two or more faces, in the order in which they occur in the faces.
std::vector<Joint> joints_of(const BodyMesh& mesh);

}  // namespace occt
