// SPDX-License-Identifier: Apache-2.0
// Points on edges along which a face turns: straight edges of ruled faces, such as the seam of a hyperboloid, have none
// between their ends, since they do not deviate from their chord. One facet beside such an edge would stand for normals
// of all directions, and be an outline of the face wherever one of them is.
#pragma once

#include <BRepMesh_EdgeDiscret.hxx>

namespace occt {

/// Divides edges as Open CASCADE does, and further until faces turn between neighbouring points no more than an arc
/// within the deflection and the angle of the parameters. Faces of simple surfaces, planes to tori, turn no more than
/// their edges, which are divided by the same angle.
class TurningEdges : public BRepMesh_EdgeDiscret {
  DEFINE_STANDARD_RTTI_INLINE(TurningEdges, BRepMesh_EdgeDiscret)

 protected:
  Standard_Boolean performInternal(const Handle(IMeshData_Model) & model, const IMeshTools_Parameters& parameters,
                                   const Message_ProgressRange& range) override;
};

}  // namespace occt
