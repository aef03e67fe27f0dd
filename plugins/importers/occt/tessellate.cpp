// SPDX-License-Identifier: Apache-2.0
#include "tessellate.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>

namespace epura_occt {

namespace {

// Of what was asked for: measured at places, the largest distance lies between them.
constexpr double enough = 1.1;
constexpr int most_rounds = 2;
// A shape of more is not done again: Open CASCADE takes minutes for twisted surfaces.
constexpr int most_facets = 50'000;
// By so much less may be asked for than is wanted: facets of twisted surfaces grow faster in number than distances
// fall.
constexpr double least_share = 0.5;

// How far a point of a facet lies off the surface, along its normal at the parameters of the point.
double distance_at(const BRepAdaptor_Surface& surface, const gp_Pnt2d& uv, const gp_Pnt& point) {
  gp_Pnt on_surface;
  gp_Vec along_u, along_v;
  surface.D1(uv.X(), uv.Y(), on_surface, along_u, along_v);
  const gp_Vec off(on_surface, point);
  const gp_Vec normal = along_u.Crossed(along_v);
  const double length = normal.Magnitude();
  // Where the surface has no normal, facets beside it tell.
  return length > 1e-9 * along_u.Magnitude() * along_v.Magnitude() ? std::abs(off.Dot(normal)) / length : 0;
}

// Edges may lie so far off the surface, and the corners of facets lie on edges.
double tolerance_of(const TopoDS_Face& face) {
  double largest = BRep_Tool::Tolerance(face);
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
  for (TopExp_Explorer vertex(face, TopAbs_VERTEX); vertex.More(); vertex.Next())
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(vertex.Current())));
  return largest;
}

// The largest distance of facets from the face's surface, beyond its tolerance.
double deflection_of(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, location);
  if (facets.IsNull() || !facets->HasUVNodes()) return 0;
  const BRepAdaptor_Surface surface(face, Standard_False);
  if (surface.GetType() == GeomAbs_Plane) return 0;
  double largest = 0;
  for (int t = 1; t <= facets->NbTriangles(); ++t) {
    int corner[3];
    facets->Triangle(t).Get(corner[0], corner[1], corner[2]);
    gp_XY uv(0, 0);
    gp_XYZ middle(0, 0, 0);
    for (const int c : corner) {
      uv += facets->UVNode(c).XY();
      middle += facets->Node(c).Transformed(location).XYZ();
    }
    largest = std::max(largest, distance_at(surface, gp_Pnt2d(uv / 3), gp_Pnt(middle / 3)));
  }
  return std::max(largest - tolerance_of(face), 0.0);
}

int facets_of(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, location);
  return facets.IsNull() ? 0 : facets->NbTriangles();
}

void make_facets(const TopoDS_Shape& shape, const Fineness& fineness, const Message_ProgressRange& range) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = fineness.deflection;
  parameters.Angle = fineness.angle;
  parameters.InParallel = fineness.parallel;
  parameters.AllowQualityDecrease = Standard_True;
  BRepMesh_IncrementalMesh(shape, parameters, range);
}

}  // namespace

double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() || box.IsOpen() ? 0 : std::sqrt(box.SquareExtent());
}

bool keeps(double distance, const Fineness& fineness) { return distance <= enough * fineness.deflection; }

double tessellate(const TopoDS_Shape& shape, const Fineness& fineness, Watch& watch) {
  Fineness finer = fineness;
  double largest = 0;
  for (int round = 0; round < most_rounds; ++round) {
    make_facets(shape, finer, watch.begin(0.5, 0.8));
    watch.expect_wanted();
    largest = 0;
    int facets = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      largest = std::max(largest, deflection_of(TopoDS::Face(face.Current())));
      facets += facets_of(TopoDS::Face(face.Current()));
    }
    if (keeps(largest, fineness) || facets > most_facets) break;
    // Of the whole shape: faces share the facets of their edges.
    finer.deflection *= std::max(0.8 * fineness.deflection / largest, least_share);
  }
  return largest;
}

}  // namespace epura_occt
