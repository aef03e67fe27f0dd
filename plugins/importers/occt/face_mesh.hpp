// SPDX-License-Identifier: Apache-2.0
// The triangles of one face, refined until they are as near to its surface as asked for.
#pragma once

#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

namespace occt {

struct FaceMesh {
  std::vector<gp_Pnt> points;    ///< first those of Open CASCADE's triangles, in its order
  std::vector<gp_Pnt2d> places;  ///< of the points, in the parameters of the surface
  std::vector<std::array<int, 3>> triangles;
  double error = 0;  ///< the largest distance from the surface that was found, as far as it exceeds the tolerance
};

/// How many times as many triangles as Open CASCADE's are still a refinement of them.
constexpr std::size_t useful_growth = 10, most_growth = 400;

/// Open CASCADE keeps to its deflection along edges, but not inside of cones, tori and surfaces of splines, where it
/// was off by up to 35 times of it. So sides between two triangles are halved until their middles, and the centres of
/// the triangles, are near enough. Edges of the face are left as they are: its neighbours have their points, too.
/// Ends with FaceMesh::error where there would be more than `growth` times as many triangles.
FaceMesh refined(const TopoDS_Face& face, double tolerance, std::size_t growth = most_growth);

}  // namespace occt
