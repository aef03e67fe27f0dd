// SPDX-License-Identifier: Apache-2.0
#include "shape_writer.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <NCollection_DataMap.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace epura_occt {

namespace {

using epura::plugin::Point;
using Numbers = std::vector<std::uint32_t>;

// Normals are compared at so many places of an edge; most of them decide.
constexpr int places = 10;
constexpr std::size_t deciding_place = 8;

epura_face description_of(const TopoDS_Face& face) {
  epura_face row{};
  const BRepAdaptor_Surface surface(face, Standard_False);
  const auto place = [&row](const gp_Pnt& origin, const gp_Dir& axis) {
    for (int i = 0; i < 3; ++i) row.origin[i] = origin.Coord(i + 1), row.axis[i] = axis.Coord(i + 1);
  };
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      row.kind = EPURA_PLANE;
      place(surface.Plane().Location(), surface.Plane().Axis().Direction());
      break;
    case GeomAbs_Cylinder:
      row.kind = EPURA_CYLINDER;
      place(surface.Cylinder().Location(), surface.Cylinder().Axis().Direction());
      row.radius = surface.Cylinder().Radius();
      break;
    case GeomAbs_Cone:
      row.kind = EPURA_CONE;
      place(surface.Cone().Location(), surface.Cone().Axis().Direction());
      row.radius = surface.Cone().RefRadius();
      row.slope = std::tan(surface.Cone().SemiAngle());
      break;
    case GeomAbs_Sphere:
      row.kind = EPURA_SPHERE;
      place(surface.Sphere().Location(), surface.Sphere().Position().Direction());
      row.radius = surface.Sphere().Radius();
      break;
    case GeomAbs_Torus:
      row.kind = EPURA_TORUS;
      place(surface.Torus().Location(), surface.Torus().Axis().Direction());
      row.radius = surface.Torus().MajorRadius();
      row.minor = surface.Torus().MinorRadius();
      break;
    default:
      row.kind = EPURA_FREE_FORM;
  }
  return row;
}

/// Outwards; nothing where the surface has none, as at a pole.
std::optional<gp_Vec> normal_of(const TopoDS_Face& face, const TopoDS_Edge& edge, double part) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return std::nullopt;
  const gp_Pnt2d uv = curve->Value(first + part * (last - first));
  gp_Pnt point;
  gp_Vec along_u, along_v;
  BRepAdaptor_Surface(face, Standard_False).D1(uv.X(), uv.Y(), point, along_u, along_v);
  gp_Vec normal = along_u.Crossed(along_v);
  if (!(normal.Magnitude() > 1e-9 * along_u.Magnitude() * along_v.Magnitude())) return std::nullopt;
  normal.Normalize();
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

/// Degrees between two faces along most of their edge; NaN where it cannot be told.
double angle_between(const TopoDS_Face& one, const TopoDS_Face& two, const TopoDS_Edge& edge) {
  std::vector<double> angles;
  for (int i = 0; i < places; ++i) {
    const double part = (i + 0.5) / places;
    const auto n = normal_of(one, edge, part), m = normal_of(two, edge, part);
    if (n && m) angles.push_back(n->Angle(*m) * (180 / std::numbers::pi));
  }
  if (angles.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(angles.begin(), angles.end());
  return angles[std::min(deciding_place, angles.size() - 1)];
}

class ShapeWriter {
 public:
  ShapeWriter(const TopoDS_Shape& shape, epura::plugin::Sink& sink) : shape_(shape), sink_(sink) {}

  Missing write(const NameOf& name_of) {
    number_bodies(name_of);
    for (TopExp_Explorer edge(shape_, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next()) ++missing_.wires;
    write_edges();
    return missing_;
  }

 private:
  // Solids are bodies; what is in none is one more.
  void number_bodies(const NameOf& name_of) {
    int solids = 0;
    for (TopExp_Explorer solid(shape_, TopAbs_SOLID); solid.More(); solid.Next()) ++solids;
    int number = 0;
    for (TopExp_Explorer solid(shape_, TopAbs_SOLID); solid.More(); solid.Next()) {
      ++number;
      std::string name = name_of(solid.Current());
      if (name.empty() && solids > 1) name = "solid " + std::to_string(number);
      if (!name.empty() || solids > 1) sink_.body(name);
      TopExp_Explorer faces(solid.Current(), TopAbs_FACE);
      write_faces(faces);
    }
    TopExp_Explorer rest(shape_, TopAbs_FACE, TopAbs_SOLID);
    if (rest.More() && solids > 0) sink_.body("faces");
    write_faces(rest);
  }

  // An explorer cannot be copied.
  void write_faces(TopExp_Explorer& faces) {
    for (; faces.More(); faces.Next()) write_face(TopoDS::Face(faces.Current()));
  }

  void write_face(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) facets = BRep_Tool::Triangulation(face, location);
    if (facets.IsNull() || facets->NbTriangles() == 0) {
      ++missing_.faces;
      return;
    }
    new_points_.clear();
    Numbers number(static_cast<std::size_t>(facets->NbNodes()), EPURA_NONE);
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
      number_edge(TopoDS::Edge(edge.Current()), facets, location, number);
    for (int i = 1; i <= facets->NbNodes(); ++i)
      if (number[i - 1] == EPURA_NONE) number[i - 1] = add_point(facets->Node(i).Transformed(location));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int t = 1; t <= facets->NbTriangles(); ++t) {
      int a = 0, b = 0, c = 0;
      facets->Triangle(t).Get(a, b, c);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
      const std::array corners{number[a - 1], number[b - 1], number[c - 1]};
      // At a pole of the surface two corners are one point.
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        triangles.push_back(corners);
    }
    sink_.points(new_points_);
    sink_.face(description_of(face));
    sink_.triangles(triangles);
  }

  std::uint32_t add_point(const gp_Pnt& point) {
    new_points_.push_back({point.X(), point.Y(), point.Z()});
    return points_++;
  }

  std::uint32_t point_of(const TopoDS_Vertex& vertex, const gp_Pnt& place) {
    if (vertex.IsNull()) return add_point(place);
    if (const std::uint32_t* known = vertices_.Seek(vertex)) return *known;
    return *vertices_.Bound(vertex, add_point(place));
  }

  // The nodes of a face along one of its edges are those of the other face there.
  void number_edge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & facets, const TopLoc_Location& location,
                   Numbers& number) {
    const Handle(Poly_PolygonOnTriangulation) polygon = BRep_Tool::PolygonOnTriangulation(edge, facets, location);
    if (polygon.IsNull()) return;
    const int count = polygon->NbNodes();
    const auto node = [&](int i) { return polygon->Node(i); };
    const auto place = [&](int i) { return facets->Node(node(i)).Transformed(location); };
    const auto end = [&](const TopoDS_Vertex& vertex, int i) {
      std::uint32_t& known = number[node(i) - 1];
      if (known == EPURA_NONE) known = point_of(vertex, place(i));
      return known;
    };
    const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    if (BRep_Tool::Degenerated(edge)) {
      for (int i = 1; i <= count; ++i) end(first, i);
      return;
    }
    const Numbers* known = edges_.Seek(edge);
    if (known != nullptr && static_cast<int>(known->size()) == count) {
      for (int i = 1; i <= count; ++i)
        if (number[node(i) - 1] == EPURA_NONE) number[node(i) - 1] = (*known)[i - 1];
      return;
    }
    Numbers along{end(first, 1)};
    for (int i = 2; i < count; ++i) {
      std::uint32_t& inner = number[node(i) - 1];
      if (inner == EPURA_NONE) inner = add_point(place(i));
      along.push_back(inner);
    }
    along.push_back(end(last, count));
    if (known == nullptr) edges_.Bind(edge, along);
  }

  // Seams, where a face meets itself, are no edges of the part.
  void write_edges() {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of;
    TopExp::MapShapesAndAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, faces_of);
    for (int i = 1; i <= faces_of.Extent(); ++i) {
      const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
      const Numbers* along = edges_.Seek(edge);
      if (along == nullptr || along->size() < 2) continue;
      const TopoDS_Face one = TopoDS::Face(faces_of(i).First());
      std::optional<TopoDS_Face> two;
      bool is_manifold = true;
      for (const TopoDS_Shape& face : faces_of(i)) {
        if (face.IsSame(one)) continue;
        is_manifold = !two || face.IsSame(*two);
        if (!two) two = TopoDS::Face(face);
      }
      if (!two) continue;
      const double angle = is_manifold ? angle_between(one, *two, edge) : std::numeric_limits<double>::quiet_NaN();
      const bool is_tangent = std::isnan(angle) && is_manifold && BRep_Tool::Continuity(edge, one, *two) > GeomAbs_C0;
      sink_.edge(*along, is_tangent, angle);
    }
  }

  const TopoDS_Shape& shape_;
  epura::plugin::Sink& sink_;
  Missing missing_;
  std::uint32_t points_ = 0;
  std::vector<Point> new_points_;  ///< of one face
  NCollection_DataMap<TopoDS_Shape, std::uint32_t, TopTools_ShapeMapHasher> vertices_;
  NCollection_DataMap<TopoDS_Shape, Numbers, TopTools_ShapeMapHasher> edges_;
};

}  // namespace

Missing write_shape(const TopoDS_Shape& shape, const std::string& name, const NameOf& name_of,
                    epura::plugin::Sink& sink) {
  sink.shape(name);
  return ShapeWriter(shape, sink).write(name_of);
}

}  // namespace epura_occt
