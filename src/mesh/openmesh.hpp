// SPDX-License-Identifier: Apache-2.0
// A mesh as an OpenMesh half-edge structure, for algorithms that walk half-edges. Include it only where one is needed.
//
// [Gueziec, Taubin, Lazarus, Horn. Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces.
// IEEE TVCG 7(2), 2001]: two triangles stay joined along an edge that only they share, in opposite directions; then
// the triangles around a vertex fall into fans, and each fan gets its own vertex. add_face would reject the triangles
// that do not fit and takes several times as long, so the surface is laid out in arrays at once.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <vector>

#include "mesh/mesh.hpp"

namespace epura::mesh {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  // Neither status flags nor stored normals: nothing is deleted, and normals follow from points.
  VertexAttributes(0);
  HalfedgeAttributes(0);
  EdgeAttributes(0);
  FaceAttributes(0);
};

using Surface = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

/// Triangle t is face t, point v is vertex v, isolated if no triangle uses it. Wires are not there.
struct HalfedgeMesh {
  Surface surface;
  /// Surface vertex -> vertex of the mesh: copies for further fans follow behind the vertices of the mesh, in the order
  /// of their lowest half-edges.
  std::vector<int> vertex_of;
};

HalfedgeMesh to_openmesh(const Mesh& mesh);

}  // namespace epura::mesh
