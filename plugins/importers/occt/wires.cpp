// SPDX-License-Identifier: Apache-2.0
#include "wires.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>
#include <numbers>
#include <utility>

namespace occt {

namespace {

class Polylines {
 public:
  Polylines(std::uint32_t first_point, const Fineness& fineness) : first_point_(first_point), fineness_(fineness) {}

  void add(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    // Divided like the edges of faces, so that a wire on a face lies in its facets where possible.
    constexpr double of_edges = 0.5;  // relative to the values given to Open CASCADE
    const GCPnts_TangentialDeflection places(curve, of_edges * fineness_.angle * std::numbers::pi / 180,
                                             of_edges * told_for_wanted * fineness_.deflection,
                                             curve.GetType() == GeomAbs_Circle ? 4 : 2);
    if (places.NbPoints() < 2) return;
    const TopoDS_Shape forward = edge.Oriented(TopAbs_FORWARD);
    TopoDS_Vertex first, last;
    TopExp::Vertices(TopoDS::Edge(forward), first, last);
    Wire wire{edge, {}};
    for (int i = 1; i <= places.NbPoints(); ++i) {
      wire.along.points.push_back(i == 1                  ? end_at(first, places.Value(i))
                                  : i < places.NbPoints() ? add_point(places.Value(i))
                                                          : end_at(last, places.Value(i)));
      wire.along.parameters.push_back(places.Parameter(i));
    }
    mesh_.wires.push_back(std::move(wire));
  }

  WireMesh mesh() && { return std::move(mesh_); }

 private:
  std::uint32_t add_point(const gp_Pnt& at) {
    mesh_.points.push_back({at.X(), at.Y(), at.Z()});
    return first_point_ + static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  std::uint32_t end_at(const TopoDS_Vertex& vertex, const gp_Pnt& at) {
    if (vertex.IsNull()) return add_point(at);
    if (const std::uint32_t* known = of_vertex_.Seek(vertex)) return *known;
    const std::uint32_t point = add_point(BRep_Tool::Pnt(vertex));
    of_vertex_.Bind(vertex, point);
    return point;
  }

  std::uint32_t first_point_;
  const Fineness& fineness_;
  WireMesh mesh_;
  NCollection_DataMap<TopoDS_Shape, std::uint32_t, TopTools_ShapeMapHasher> of_vertex_;
};

}  // namespace

WireMesh mesh_of(const std::vector<TopoDS_Edge>& edges, std::uint32_t first_point, const Fineness& fineness) {
  Polylines polylines(first_point, fineness);
  for (const TopoDS_Edge& edge : edges) polylines.add(edge);
  return std::move(polylines).mesh();
}

}  // namespace occt
