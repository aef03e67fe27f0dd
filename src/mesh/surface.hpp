// SPDX-License-Identifier: Apache-2.0
// The half-edge structure of a model: OpenMesh triangles with double coordinates.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace epura {

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

}  // namespace epura
