// SPDX-License-Identifier: Apache-2.0
// Faces and edges of a part as a file declares them, completed by recognition where it does not.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"
#include "surfaces/part_surface.hpp"
#include "surfaces/recognise.hpp"

namespace epura::surfaces {

/// An edge of the part between two of its faces.
struct DeclaredEdge {
  double angle;  ///< degrees between the faces; NaN: take the angle between facets
  int is_tangent;
  int end;  ///< end of its vertices in DeclaredPart::edge_vertices
};

/// Lengths and positions are in units of the file.
struct DeclaredPart {
  std::vector<PartSurface> faces;
  std::vector<int> face_of_polygon;  ///< of the file
  std::vector<DeclaredEdge> edges;
  std::vector<int> edge_vertices;  ///< points of the file along the edges, one edge after the other
};

/// Transfers the declared part to the mesh that was made from the file's polygons. Where different faces meet without a
/// declared edge, facets decide about the border; faces that lost all their triangles are left out. Neighbours on one
/// round surface become one face, since modellers split full turns into halves. Faces that meet within `tangent_angle`
/// degrees are tangent.
PartFaces part_of(const mesh::Mesh& mesh, const DeclaredPart& declared, double tangent_angle);

/// A mesh of which some triangles were replaced, and its faces.
struct ReplacedTriangles {
  const mesh::Mesh& mesh;
  std::vector<int> face_of_triangle;  ///< as numbered before; `added` comes after these
  PartSurface added;
};

/// Keeps a declared part where the triangles are the same, with one more face. `before` is the mesh of the part.
PartFaces part_with_face(const PartFaces& part, const mesh::Mesh& before, const ReplacedTriangles& now,
                         double tangent_angle);

}  // namespace epura::surfaces
