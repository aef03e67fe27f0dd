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
#include <BRep_Tool.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
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
#include <epura/opencascade_spline.hpp>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <utility>
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
    if (!has_facets()) BRepMesh_IncrementalMesh(shape_, deflection_, false, max_turn, false);
    sink_.shape(sink_.host, "");
    TopTools_IndexedMapOfShape solids;
    TopExp::MapShapes(shape_, TopAbs_SOLID, solids);
    for (int i = 1; i <= solids.Extent() && solids.Extent() > 1; ++i) {
      sink_.body(sink_.host, "");
      add_faces(solids(i));
    }
    add_faces(shape_);
    for (std::size_t i = 0; i < uses_.size(); ++i) add_edge(TopoDS::Edge(edges_(static_cast<int>(i) + 1)), uses_[i]);
    for (TopExp_Explorer at(shape_, TopAbs_EDGE, TopAbs_FACE); at.More(); at.Next()) {
      const int known = edges_.Extent();
      if (edges_.Add(at.Current()) > known) add_wire(TopoDS::Edge(at.Current()));
    }
    return added_;
  }

 private:
  static constexpr std::uint32_t none = EPURA_NONE;
  static constexpr double max_turn = 0.35;  ///< radians between facets
  static constexpr double smooth = 0.01;    ///< radians between faces that meet smoothly, as files state tangency
  static constexpr double degrees = 57.29577951308232;
  using Ids = std::vector<std::uint32_t>;

  /// What is known of an edge of a face.
  struct Use {
    Ids ids;                         ///< of the points along it, which its faces share
    std::vector<double> parameters;  ///< of these, on its curve
    std::array<int, 2> faces{0, 0};  ///< that it bounds, from 1; a seam bounds one twice
    int count = 0;                   ///< of such faces, which may be more
  };

  bool has_facets() const {
    TopLoc_Location location;
    for (TopExp_Explorer at(shape_, TopAbs_FACE); at.More(); at.Next()) {
      const Handle(Poly_Triangulation)& facets = BRep_Tool::Triangulation(TopoDS::Face(at.Current()), location);
      if (facets.IsNull() || facets->Deflection() > deflection_) return false;
    }
    return true;
  }

  std::uint32_t add_point(const gp_Pnt& p) {
    coordinates_.insert(coordinates_.end(), {p.X(), p.Y(), p.Z()});
    return points_++;
  }

  void hand_over_points() {
    sink_.points(sink_.host, coordinates_.size() / 3, coordinates_.data());
    coordinates_.clear();
  }

  std::uint32_t id_of(const TopoDS_Vertex& vertex) {
    const auto index = static_cast<std::size_t>(vertices_.Add(vertex));
    if (index > vertex_ids_.size()) vertex_ids_.push_back(add_point(BRep_Tool::Pnt(vertex)));
    return vertex_ids_[index - 1];
  }

  // From the first vertex of the edge to its last one.
  Ids ids_along(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& polygon, const Poly_Triangulation& facets,
                const gp_Trsf& place) {
    const auto forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward), last = TopExp::LastVertex(forward);
    const int count = polygon.NbNodes();
    Ids ids;
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
    const Handle(Poly_Triangulation)& facets = BRep_Tool::Triangulation(face, location);
    Ids ids(facets.IsNull() ? 0 : static_cast<std::size_t>(facets->NbNodes()), none);
    for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next())
      share_points(TopoDS::Edge(at.Current()), facets, location, ids);
    if (facets.IsNull()) return;
    const gp_Trsf place = location.Transformation();
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] == none) ids[i] = add_point(facets->Node(static_cast<int>(i) + 1).Transformed(place));
    hand_over_points();
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

  /// An edge and the place of its face where Open CASCADE looks for what both have in common: relative to each other.
  /// Its products of places are most of the time of a part that is placed somewhere, and here are mostly one.
  static std::pair<TopoDS_Edge, TopLoc_Location> relative(const TopoDS_Edge& edge, const TopLoc_Location& place) {
    if (edge.Location() != place) return {edge, place};
    return {TopoDS::Edge(edge.Located(TopLoc_Location())), TopLoc_Location()};
  }

  void share_points(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & facets, const TopLoc_Location& location,
                    Ids& ids) {
    const auto index = static_cast<std::size_t>(edges_.Add(edge)) - 1;
    if (index == uses_.size()) uses_.emplace_back();
    Use& use = uses_[index];
    if (use.count < 2) use.faces[static_cast<std::size_t>(use.count)] = static_cast<int>(added_.faces.size());
    ++use.count;
    if (facets.IsNull()) return;
    const auto [alone, place] = relative(edge, location);
    const Handle(Poly_PolygonOnTriangulation)& polygon = BRep_Tool::PolygonOnTriangulation(alone, facets, place);
    if (polygon.IsNull()) return;
    const auto id_at = [&](int i) -> std::uint32_t& { return ids[static_cast<std::size_t>(polygon->Node(i)) - 1]; };
    if (BRep_Tool::Degenerated(edge)) {
      for (int i = 1; i <= polygon->NbNodes(); ++i) id_at(i) = id_of(TopExp::FirstVertex(edge));
      return;
    }
    if (use.ids.empty()) {
      use.ids = ids_along(edge, *polygon, *facets, location.Transformation());
      if (polygon->HasParameters()) use.parameters.assign(polygon->Parameters()->begin(), polygon->Parameters()->end());
    }
    if (use.ids.size() != static_cast<std::size_t>(polygon->NbNodes())) return;  // meshed apart: a crack
    for (int i = 1; i <= polygon->NbNodes(); ++i) id_at(i) = use.ids[static_cast<std::size_t>(i) - 1];
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

  // At three places along an edge of a face by its number; false if there is none. A plane needs no curve, which Open
  // CASCADE would have to find.
  bool find_normals(const TopoDS_Edge& edge, int number, Normals& normals) const {
    const auto i = static_cast<std::size_t>(number) - 1;
    const TopoDS_Face& face = added_.faces[i];
    const BRepAdaptor_Surface& surface = surfaces_[i];
    if (surface.GetType() == GeomAbs_Plane) {
      const gp_Pln plane = surface.Plane();
      normals.fill(gp_Vec(plane.Position().XDirection()).Crossed(plane.Position().YDirection()));
    } else {
      double from = 0, to = 0;
      TopLoc_Location location;
      const Handle(Geom_Surface)& form = BRep_Tool::Surface(face, location);
      const auto [alone, place] = relative(edge, location);
      const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(alone, form, place, from, to);
      if (curve.IsNull()) return false;
      for (std::size_t n = 0; n < normals.size(); ++n) {
        const gp_Pnt2d at = curve->Value(from + 0.25 * static_cast<double>(n + 1) * (to - from));
        gp_Pnt point;
        gp_Vec u, v;
        surface.D1(at.X(), at.Y(), point, u, v);
        normals[n] = u.Crossed(v);
        if (normals[n].SquareMagnitude() == 0) return false;
      }
    }
    if (face.Orientation() == TopAbs_REVERSED)
      for (gp_Vec& normal : normals) normal.Reverse();
    return true;
  }

  // Radians between the normals of both faces, where they differ most.
  double angle_at(const TopoDS_Edge& edge, const std::array<int, 2>& faces) const {
    Normals normals, others;
    if (!find_normals(edge, faces[0], normals) || !find_normals(edge, faces[1], others)) return std::nan("");
    double largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) largest = std::max(largest, normals[i].Angle(others[i]));
    return largest;
  }

  void add_edge(const TopoDS_Edge& edge, const Use& use) {
    if (use.ids.size() < 2 || use.count != 2 || use.faces[0] == use.faces[1]) return;  // a border or a seam
    const double angle = angle_at(edge, use.faces);
    const std::uint32_t kind = angle <= smooth ? EPURA_TANGENT : EPURA_SHARP;
    const epura_edge told{sizeof told, kind, angle * degrees, use.ids.size(), use.ids.data()};
    sink_.edge(sink_.host, &told);
    add_spline(edge, use.parameters);
    added_.edges.push_back(edge);
  }

  void add_spline(const TopoDS_Edge& edge, std::vector<double> parameters) {
    const OpenCascadeSpline spline(edge, std::move(parameters));
    epura_spline told;
    if (spline.told(told)) sink_.spline(sink_.host, &told);
  }

  void add_wire(const TopoDS_Edge& edge) {
    if (BRep_Tool::Degenerated(edge)) return;
    const BRepAdaptor_Curve curve(edge);
    const GCPnts_TangentialDeflection along(curve, max_turn, deflection_);
    Ids ids;
    std::vector<double> parameters;
    for (int i = 1; i <= along.NbPoints(); ++i) {
      ids.push_back(add_point(along.Value(i)));
      parameters.push_back(along.Parameter(i));
    }
    hand_over_points();
    if (ids.size() < 2) return;
    const epura_edge told{sizeof told, EPURA_WIRE, std::nan(""), ids.size(), ids.data()};
    sink_.edge(sink_.host, &told);
    add_spline(edge, std::move(parameters));
    added_.wires.push_back(edge);
  }

  const epura_sink& sink_;
  const TopoDS_Shape& shape_;
  double deflection_;
  TopTools_IndexedMapOfShape vertices_, edges_, known_faces_;
  Ids vertex_ids_;
  std::vector<Use> uses_;                     ///< of edges of faces
  std::deque<BRepAdaptor_Surface> surfaces_;  ///< of added_.faces
  std::vector<double> coordinates_;           ///< of points that are not handed over yet
  std::uint32_t points_ = 0;
  AddedShape added_;
};

/// Hands over a shape as one shape of the model that is being filled, in facets that are off by `deflection` at most;
/// it keeps finer ones if it has some. Wrong calls show in epura_hlr_finish. Throws what Open CASCADE throws.
inline AddedShape add_shape(const epura_sink& sink, const TopoDS_Shape& shape, double deflection) {
  return OpenCascadeShape(sink, shape, deflection).add();
}

}  // namespace epura
