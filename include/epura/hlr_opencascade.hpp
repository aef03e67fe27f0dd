// SPDX-License-Identifier: Apache-2.0
// Shapes of Open CASCADE for hidden-line removal in memory (epura/hlr.h), in one header: whoever includes it links Open
// CASCADE (TKMesh TKTopAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel) and libepura-hlr.
//
//   epura_hlr_model* model = epura_hlr_model_new(EPURA_HLR_VERSION);
//   const epura::AddedShape added = epura::add_shape(*epura_hlr_sink(model), shape, 0.01);
//   ... epura_hlr_finish, epura_hlr_draw ...
//   added.faces[curve.faces[0].face], added.edges[curve.edge]
#pragma once

#include <epura/hlr.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <vector>

namespace epura {

/// The shapes behind the numbers of curves. Wires have numbers of their own (EPURA_HLR_WIRE).
struct AddedShape {
  std::vector<TopoDS_Face> faces;
  std::vector<TopoDS_Edge> edges, wires;
};

/// Hands over one shape, with its faces, their surfaces, and its edges.
class OpenCascadeShape {
 public:
  OpenCascadeShape(const epura_sink& sink, const TopoDS_Shape& shape, double deflection)
      : sink_(sink), shape_(shape), deflection_(deflection) {}

  AddedShape add() {
    if (!BRepTools::Triangulation(shape_, deflection_, false))
      BRepMesh_IncrementalMesh(shape_, deflection_, false, max_turn, false);
    TopExp::MapShapes(shape_, TopAbs_VERTEX, vertices_);
    TopExp::MapShapesAndAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, faces_of_edge_);
    vertex_ids_.assign(static_cast<std::size_t>(vertices_.Extent()), none);
    edge_ids_.resize(static_cast<std::size_t>(faces_of_edge_.Extent()));
    sink_.shape(sink_.host, "");
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(shape_, TopAbs_SOLID, solids);
    for (int i = 1; i <= solids.Extent() && solids.Extent() > 1; ++i) {
      sink_.body(sink_.host, "");
      add_faces(solids(i));
    }
    add_faces(shape_);
    for (int i = 1; i <= faces_of_edge_.Extent(); ++i) add_edge(i);
    return added_;
  }

 private:
  static constexpr std::uint32_t none = EPURA_NONE;
  static constexpr double max_turn = 0.35;  ///< radians between facets
  static constexpr double smooth = 0.01;    ///< radians between faces that meet smoothly, as files state tangency
  static constexpr double degrees = 57.29577951308232;
  using Ids = std::vector<std::uint32_t>;

  std::uint32_t add_point(const gp_Pnt& p) {
    const double xyz[]{p.X(), p.Y(), p.Z()};
    sink_.points(sink_.host, 1, xyz);
    return points_++;
  }

  std::uint32_t id_of(const TopoDS_Vertex& vertex) {
    std::uint32_t& id = vertex_ids_[static_cast<std::size_t>(vertices_.FindIndex(vertex)) - 1];
    if (id == none) id = add_point(BRep_Tool::Pnt(vertex));
    return id;
  }

  // The points along an edge, which its faces share, from its first vertex to its last one.
  Ids& ids_along(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& polygon, const Poly_Triangulation& facets,
                 const gp_Trsf& place) {
    Ids& ids = edge_ids_[static_cast<std::size_t>(faces_of_edge_.FindIndex(edge)) - 1];
    if (!ids.empty()) return ids;
    const auto forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
    const int count = polygon.NbNodes();
    for (int i = 1; i <= count; ++i) {
      if (i == 1 && !first.IsNull())
        ids.push_back(id_of(first));
      else if (i == count && !last.IsNull())
        ids.push_back(id_of(last));
      else
        ids.push_back(add_point(facets.Node(polygon.Node(i)).Transformed(place)));
    }
    return ids;
  }

  void add_faces(const TopoDS_Shape& shape) {
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
      if (known_faces_.Add(at.Current()) > static_cast<int>(added_.faces.size())) add_face(TopoDS::Face(at.Current()));
  }

  void add_face(const TopoDS_Face& face) {
    added_.faces.push_back(face);
    surfaces_.emplace_back(face, false);  // without its borders, which take time
    const epura_face surface = told_of(surfaces_.back());
    sink_.face(sink_.host, &surface);
    TopLoc_Location location;
    const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, location);
    if (facets.IsNull()) return;
    const gp_Trsf place = location.Transformation();
    Ids ids(static_cast<std::size_t>(facets->NbNodes()), none);
    for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next())
      share_points(TopoDS::Edge(at.Current()), facets, location, ids);
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] == none) ids[i] = add_point(facets->Node(static_cast<int>(i) + 1).Transformed(place));
    const bool turned = (face.Orientation() == TopAbs_REVERSED) != place.IsNegative();
    Ids corners;
    std::vector<std::uint64_t> ends;
    for (int t = 1; t <= facets->NbTriangles(); ++t) {
      std::array<int, 3> nodes{};
      facets->Triangle(t).Get(nodes[0], nodes[1], nodes[2]);
      if (turned) std::swap(nodes[1], nodes[2]);
      const auto id = [&](int i) { return ids[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)]) - 1]; };
      if (id(0) == id(1) || id(1) == id(2) || id(2) == id(0)) continue;  // at a pole
      for (const int i : {0, 1, 2}) corners.push_back(id(i));
      ends.push_back(corners.size());
    }
    sink_.polygons(sink_.host, ends.size(), ends.data(), corners.data());
  }

  void share_points(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & facets, const TopLoc_Location& location,
                    Ids& ids) {
    const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, facets, location);
    if (polygon.IsNull()) return;
    const auto id_at = [&](int i) -> std::uint32_t& { return ids[static_cast<std::size_t>(polygon->Node(i)) - 1]; };
    if (BRep_Tool::Degenerated(edge)) {
      for (int i = 1; i <= polygon->NbNodes(); ++i) id_at(i) = id_of(TopExp::FirstVertex(edge));
      return;
    }
    const Ids& along = ids_along(edge, *polygon, *facets, location.Transformation());
    if (along.size() != static_cast<std::size_t>(polygon->NbNodes())) return;  // meshed apart: a crack
    for (int i = 1; i <= polygon->NbNodes(); ++i) id_at(i) = along[static_cast<std::size_t>(i) - 1];
  }

  static void put(double (&to)[3], const gp_XYZ& from) {
    for (int i = 0; i < 3; ++i) to[i] = from.Coord(i + 1);
  }

  static epura_face told_of(const BRepAdaptor_Surface& surface) {
    epura_face told{};
    told.size = sizeof told;
    const auto describe = [&](std::uint32_t kind, const gp_Ax3& axes, double radius) {
      told.kind = kind;
      put(told.origin, axes.Location().XYZ());
      put(told.axis, axes.Direction().XYZ());
      told.radius = radius;
    };
    switch (surface.GetType()) {
      case GeomAbs_Plane:
        describe(EPURA_PLANE, surface.Plane().Position(), 0);
        break;
      case GeomAbs_Cylinder:
        describe(EPURA_CYLINDER, surface.Cylinder().Position(), surface.Cylinder().Radius());
        break;
      case GeomAbs_Cone:
        describe(EPURA_CONE, surface.Cone().Position(), surface.Cone().RefRadius());
        told.slope = std::tan(surface.Cone().SemiAngle());
        break;
      case GeomAbs_Sphere:
        describe(EPURA_SPHERE, surface.Sphere().Position(), surface.Sphere().Radius());
        break;
      case GeomAbs_Torus:
        describe(EPURA_TORUS, surface.Torus().Position(), surface.Torus().MajorRadius());
        told.minor = surface.Torus().MinorRadius();
        break;
      default:
        told.kind = EPURA_FREE_FORM;
    }
    return told;
  }

  using Normals = std::array<gp_Vec, 3>;

  // At three places along an edge; false if there is none. A plane needs no curve, which Open CASCADE would have to
  // find.
  bool find_normals(const TopoDS_Edge& edge, const TopoDS_Face& face, Normals& normals) const {
    const BRepAdaptor_Surface& surface = surfaces_[static_cast<std::size_t>(known_faces_.FindIndex(face)) - 1];
    if (surface.GetType() == GeomAbs_Plane) {
      const gp_Pln plane = surface.Plane();
      normals.fill(gp_Vec(plane.Position().XDirection()).Crossed(plane.Position().YDirection()));
    } else {
      double from = 0, to = 0;
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
      if (curve.IsNull()) return false;
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const gp_Pnt2d at = curve->Value(from + 0.25 * static_cast<double>(i + 1) * (to - from));
        gp_Pnt point;
        gp_Vec u, v;
        surface.D1(at.X(), at.Y(), point, u, v);
        normals[i] = u.Crossed(v);
        if (normals[i].SquareMagnitude() == 0) return false;
      }
    }
    if (face.Orientation() == TopAbs_REVERSED)
      for (gp_Vec& normal : normals) normal.Reverse();
    return true;
  }

  // Radians between the normals of both faces, where they differ most.
  double angle_at(const TopoDS_Edge& edge, const TopoDS_Face& one, const TopoDS_Face& other) const {
    Normals normals, others;
    if (!find_normals(edge, one, normals) || !find_normals(edge, other, others)) return std::nan("");
    double largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) largest = std::max(largest, normals[i].Angle(others[i]));
    return largest;
  }

  void add_edge(int number) {
    const TopoDS_Edge edge = TopoDS::Edge(faces_of_edge_.FindKey(number));
    if (BRep_Tool::Degenerated(edge)) return;
    const TopTools_ListOfShape& faces = faces_of_edge_(number);
    if (faces.IsEmpty()) return add_wire(edge);
    const Ids& ids = edge_ids_[static_cast<std::size_t>(number) - 1];
    if (ids.size() < 2 || faces.Extent() != 2 || faces.First().IsSame(faces.Last())) return;  // a border or a seam
    const double angle = angle_at(edge, TopoDS::Face(faces.First()), TopoDS::Face(faces.Last()));
    const std::uint32_t kind = angle <= smooth ? EPURA_TANGENT : EPURA_SHARP;
    const epura_edge told{sizeof told, kind, angle * degrees, ids.size(), ids.data()};
    sink_.edge(sink_.host, &told);
    added_.edges.push_back(edge);
  }

  void add_wire(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    const GCPnts_TangentialDeflection along(curve, max_turn, deflection_);
    Ids ids;
    for (int i = 1; i <= along.NbPoints(); ++i) ids.push_back(add_point(along.Value(i)));
    if (ids.size() < 2) return;
    const epura_edge told{sizeof told, EPURA_WIRE, std::nan(""), ids.size(), ids.data()};
    sink_.edge(sink_.host, &told);
    added_.wires.push_back(edge);
  }

  const epura_sink& sink_;
  const TopoDS_Shape& shape_;
  double deflection_;
  TopTools_IndexedMapOfShape vertices_, known_faces_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge_;
  Ids vertex_ids_;
  std::vector<Ids> edge_ids_;
  std::deque<BRepAdaptor_Surface> surfaces_;  ///< of added_.faces
  std::uint32_t points_ = 0;
  AddedShape added_;
};

/// Hands over a shape as one shape of the model that is being filled, in facets that are off by `deflection` at most;
/// it keeps finer ones if it has some. Wrong calls show in epura_hlr_finish. Throws what Open CASCADE throws.
inline AddedShape add_shape(const epura_sink& sink, const TopoDS_Shape& shape, double deflection) {
  return OpenCascadeShape(sink, shape, deflection).add();
}

}  // namespace epura
