// SPDX-License-Identifier: Apache-2.0
// The triangles of one face, refined until they are within a given distance of its surface.
#pragma once

#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

namespace occt {

struct FaceMesh {
  std::vector<gp_Pnt> points;    ///< those of Open CASCADE's triangles first, in its order
  std::vector<gp_Pnt2d> places;  ///< of the points, as parameters of the surface
  std::vector<std::array<int, 3>> triangles;
  double error = 0;  ///< the largest distance found from the surface, if it exceeds the tolerance
};

/// Limits for the number of triangles relative to Open CASCADE's.
constexpr std::size_t useful_growth = 10, max_growth = 400;

/// Open CASCADE respects its deflection along edges, but not inside cones, tori and spline surfaces, where it was
/// exceeded by a factor of up to 35. Therefore sides between two triangles are halved until their middles, and the
/// centres of the triangles, are close enough. Edges of the face are left unchanged, because its neighbours have their
/// points, too. Stops and sets FaceMesh::error if there would be more than `growth` times as many triangles.
FaceMesh refined(const TopoDS_Face& face, double tolerance, std::size_t growth = max_growth);

}  // namespace occt
