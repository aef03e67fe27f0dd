// SPDX-License-Identifier: Apache-2.0
// Faces and edges of a part as a file declares them, beside what recognition finds where it does not.
#pragma once

#include <vector>

#include "features/part_surface.hpp"
#include "features/recognise.hpp"
#include "mesh/mesh.hpp"

namespace epura::features {

/// An edge of the part between two of its faces.
struct DeclaredEdge {
  double angle;  ///< degrees between the faces; NaN: that of the facets
  bool is_tangent;
  int end;  ///< where its vertices end in DeclaredPart::edge_vertices
};

/// Lengths and places are the file's.
struct DeclaredPart {
  std::vector<PartSurface> faces;
  std::vector<int> face_of_polygon;  ///< of the file
  std::vector<DeclaredEdge> edges;
  std::vector<int> edge_vertices;  ///< of all edges, one after the other: points of the file along them
};

/// The same of the mesh that the file's polygons became. Where different faces meet and no edge is declared, facets
/// tell how; faces that lost all their triangles are left out. Neighbours on one round surface are one face, as
/// modellers split whole turns in halves. Tangent are faces that meet within `tangent_angle` degrees.
PartFaces part_of(const mesh::Mesh& mesh, const DeclaredPart& declared, double tangent_angle);

}  // namespace epura::features
