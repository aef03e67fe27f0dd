// SPDX-License-Identifier: Apache-2.0
#include "body_mesh.hpp"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <utility>

#include "face_mesh.hpp"

namespace occt {

namespace {

using Point = epura::plugin::Point;
using Number = std::uint32_t;

Point point_of(const gp_Pnt& point) { return {point.X(), point.Y(), point.Z()}; }

class Numbering {
 public:
  Numbering(BodyMesh& mesh, Number first_point, double tolerance)
      : mesh_(mesh), first_point_(first_point), tolerance_(tolerance) {}

  void add(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    if (triangles.IsNull() || triangles->NbTriangles() == 0) {
      ++mesh_.unmeshed_faces;
      return;
    }
    triangles_ = triangles;
    location_ = location;
    face_ = refined(face, tolerance_);
    mesh_.error = std::max(mesh_.error, face_.error);
    numbers_.assign(face_.points.size(), EPURA_NONE);
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) number(TopoDS::Edge(edges.Current()));
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      if (numbers_[i] == EPURA_NONE) numbers_[i] = add_point(face_.points[i]);
    mesh_.faces.push_back({face, corners(face)});
  }

 private:
  [[nodiscard]] gp_Pnt position(int node) const {
    return triangles_->Node(node).Transformed(location_.Transformation());
  }

  Number add_point(const gp_Pnt& point) {
    mesh_.points.push_back(point_of(point));
    return first_point_ + static_cast<Number>(mesh_.points.size() - 1);
  }

  Number number_of(const TopoDS_Vertex& vertex, const gp_Pnt& point) {
    if (vertex.IsNull()) return add_point(point);
    const int index = vertices_.FindIndex(vertex);
    if (index != 0) return vertices_(index);
    return vertices_(vertices_.Add(vertex, add_point(point)));
  }

  /// The nodes along the edge get the numbers that it has from another face, or new ones.
  void number(const TopoDS_Edge& edge) {
    const Handle(Poly_PolygonOnTriangulation) line = BRep_Tool::PolygonOnTriangulation(edge, triangles_, location_);
    if (line.IsNull()) return;
    const TopoDS_Shape key = edge.Oriented(TopAbs_FORWARD);
    int index = mesh_.edges.FindIndex(key);
    if (index == 0) index = mesh_.edges.Add(key, new_points(TopoDS::Edge(key), *line));
    const std::vector<Number>& points = mesh_.edges(index).points;
    if (static_cast<int>(points.size()) != line->NbNodes()) {
      ++mesh_.gaps;
      numbers_[line->Node(1) - 1] = points.front();
      numbers_[line->Node(line->NbNodes()) - 1] = points.back();
      return;
    }
    for (int i = 1; i <= line->NbNodes(); ++i) numbers_[line->Node(i) - 1] = points[i - 1];
  }

  Along new_points(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& line) {
    const int count = line.NbNodes();
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge, first, last);
    std::vector<Number> points{number_of(first, position(line.Node(1)))};
    if (BRep_Tool::Degenerated(edge)) return {std::vector<Number>(count, points.front())};
    for (int i = 2; i < count; ++i) points.push_back(add_point(position(line.Node(i))));
    const bool is_ring_without_vertex = first.IsNull() && last.IsNull() && BRep_Tool::IsClosed(edge);
    points.push_back(is_ring_without_vertex ? points.front() : number_of(last, position(line.Node(count))));
    Along along{std::move(points)};
    if (line.HasParameters()) along.parameters.assign(line.Parameters()->begin(), line.Parameters()->end());
    return along;
  }

  [[nodiscard]] std::vector<std::array<Number, 3>> corners(const TopoDS_Face& face) const {
    const bool is_mirrored = location_.Transformation().IsNegative();
    const bool is_swapped = (face.Orientation() == TopAbs_REVERSED) != is_mirrored;
    std::vector<std::array<Number, 3>> found;
    for (auto [a, b, c] : face_.triangles) {
      if (is_swapped) std::swap(b, c);
      const std::array<Number, 3> triangle{numbers_[a], numbers_[b], numbers_[c]};
      // Triangles that collapse at a pole have no area.
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
        found.push_back(triangle);
    }
    return found;
  }

  BodyMesh& mesh_;
  Number first_point_;
  double tolerance_;
  NCollection_IndexedDataMap<TopoDS_Shape, Number, TopTools_ShapeMapHasher> vertices_;
  Handle(Poly_Triangulation) triangles_;  // of the current face
  TopLoc_Location location_;
  FaceMesh face_;
  std::vector<Number> numbers_;  // of its points
};

double volume_of(const BodyMesh& mesh, Number first_point) {
  double sixfold = 0;
  const Point origin = mesh.points.empty() ? Point{} : mesh.points.front();
  for (const Facets& facets : mesh.faces) {
    for (const auto& triangle : facets.triangles) {
      std::array<gp_Vec, 3> corners;
      for (int i = 0; i < 3; ++i) {
        const Point& point = mesh.points[triangle[i] - first_point];
        corners[i] = gp_Vec(point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]);
      }
      sixfold += corners[0].Dot(corners[1].Crossed(corners[2]));
    }
  }
  return sixfold / 6;
}

}  // namespace

BodyMesh mesh_of(const TopoDS_Shape& body, Number first_point, double tolerance) {
  BodyMesh mesh;
  Numbering numbering(mesh, first_point, tolerance);
  TopTools_IndexedMapOfShape seen;
  for (TopExp_Explorer faces(body, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face& face = TopoDS::Face(faces.Current());
    const bool bounds = face.Orientation() == TopAbs_FORWARD || face.Orientation() == TopAbs_REVERSED;
    const int known = seen.Extent();
    if (seen.Add(face) <= known) continue;
    if (bounds) {
      numbering.add(face);
    } else {
      ++mesh.inner_faces;
    }
  }
  if (body.ShapeType() != TopAbs_SOLID || !(volume_of(mesh, first_point) < 0)) return mesh;
  mesh.is_turned = true;
  for (Facets& facets : mesh.faces) {
    facets.face.Reverse();
    for (auto& triangle : facets.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

}  // namespace occt
