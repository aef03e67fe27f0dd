// SPDX-License-Identifier: Apache-2.0
// Converts a mesh to an OpenMesh half-edge structure, for algorithms that traverse half-edges. Include it only where
// needed.
//
// [Gueziec, Taubin, Lazarus, Horn. Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces. IEEE TVCG
// 7(2), 2001]: two triangles remain joined along an edge that only they share, in opposite directions; the triangles
// around a vertex then form fans, and each fan gets its own vertex. add_face would reject the triangles that do not
// fit, and takes several times as long, so the surface is written to arrays directly.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "mesh/mesh.hpp"

namespace epura::mesh {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  // No status flags and no stored normals: nothing is deleted, and normals follow from points.
  VertexAttributes(0);
  HalfedgeAttributes(0);
  EdgeAttributes(0);
  FaceAttributes(0);
};

using Surface = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// Triangle t is face t, and point v is vertex v, isolated if no triangle uses it. Wires are not included.
struct HalfedgeMesh {
  Surface surface;
  /// Surface vertex -> vertex of the mesh. Copies for further fans follow the vertices of the mesh, in order of their
  /// lowest half-edges.
  std::vector<int> vertex_of;
};

HalfedgeMesh to_openmesh(const Mesh& mesh);

}  // namespace epura::mesh
