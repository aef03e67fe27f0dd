// SPDX-License-Identifier: Apache-2.0
// The form of a mesh in which HLRBRep_PolyAlgo 7.6 draws it correctly and as fast as possible:
// - one face for each patch between creases, with its own triangulation and no surface; one face for each triangle is
//   some 70 times slower;
// - one edge for each mesh edge at the rim of a patch, with a curve in space, a curve in parameters (required, but not
//   used) and its nodes in the triangulation of each face;
// - normals and parameters at the nodes, since otherwise there are no outlines;
// - one shell for each connected part, marked as closed if it is: then back faces need not hide.
#include "occ_hlr.hpp"

#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Line.hxx>
#include <HLRAlgo_EdgeIterator.hxx>
#include <HLRAlgo_EdgeStatus.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <utility>

namespace epura::bench {

using namespace mesh;

namespace {

struct Faces {
  std::vector<Handle(Poly_Triangulation)> triangulations;  ///< by patch
  std::vector<TopoDS_Face> faces;                          ///< by patch
  std::vector<TopoDS_Wire> rims;                           ///< by patch
  std::vector<int> number;                                 ///< of each node in its triangulation, from 1
};

Faces empty_faces(const Patches& cut) {
  Faces result;
  result.number.assign(static_cast<std::size_t>(cut.node_count), 0);
  std::vector<int> nodes(static_cast<std::size_t>(cut.patch_count), 0), triangles = nodes;
  for (std::size_t h = 0; h < cut.node.size(); ++h) {
    const int patch = cut.patch[h / 3];
    if (result.number[cut.node[h]] == 0) result.number[cut.node[h]] = ++nodes[patch];
    triangles[patch] += h % 3 == 0;
  }
  const BRep_Builder builder;
  for (int p = 0; p < cut.patch_count; ++p) {
    result.triangulations.push_back(new Poly_Triangulation(nodes[p], triangles[p], /*hasUVNodes=*/true));
    result.triangulations.back()->AddNormals();
    builder.MakeFace(result.faces.emplace_back(), result.triangulations.back());
    builder.MakeWire(result.rims.emplace_back());
  }
  return result;
}

/// 0 for a degenerate corner.
double corner_angle(const TriangleMesh& mesh, int halfedge) {
  const int next = next_in_triangle(halfedge);
  const Vec3& corner = mesh.points[mesh.corners[halfedge]];
  const Vec3 u = mesh.points[mesh.corners[next]] - corner,
             v = mesh.points[mesh.corners[next_in_triangle(next)]] - corner;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

/// Mean normals of the triangles, weighted by their angles (Thuermer and Wuethrich, JGT 3(1), 1998), so that the
/// diagonals of a cylinder's facets do not affect them.
std::vector<Vec3> node_normals(const TriangleMesh& mesh, const Patches& cut) {
  const auto unit = [](const Vec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : Vec3(0, 0, 1);
  };
  std::vector<Vec3> normals(static_cast<std::size_t>(cut.node_count), Vec3(0));
  for (int h = 0; h < static_cast<int>(cut.node.size()); ++h)
    normals[cut.node[h]] += corner_angle(mesh, h) * unit(cut.area[h / 3]);
  for (Vec3& normal : normals) normal = unit(normal);
  return normals;
}

void fill_triangulations(Faces& faces, const TriangleMesh& mesh, const Patches& cut) {
  const std::vector<Vec3> normals = node_normals(mesh, cut);
  std::vector<int> filled(faces.faces.size(), 0);
  for (std::size_t t = 0; t < cut.patch.size(); ++t) {
    const Handle(Poly_Triangulation)& triangulation = faces.triangulations[cut.patch[t]];
    std::array<int, 3> number{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int node = cut.node[3 * t + k];
      const Vec3& p = mesh.points[mesh.corners[3 * t + k]];
      const Vec3& n = normals[node];
      number[k] = faces.number[node];
      triangulation->SetNode(number[k], gp_Pnt(p.x, p.y, p.z));
      triangulation->SetUVNode(number[k], gp_Pnt2d(p.x, p.y));
      triangulation->SetNormal(number[k], gp_Vec3f(float(n.x), float(n.y), float(n.z)));
    }
    triangulation->SetTriangle(++filled[cut.patch[t]], Poly_Triangle(number[0], number[1], number[2]));
  }
}

/// The two nodes of a half-edge in its face, the lower vertex of its edge first.
Handle(Poly_PolygonOnTriangulation)
    polygon_of(const Faces& faces, const Patches& cut, int halfedge, bool ascending, double length) {
  int from = faces.number[cut.node[halfedge]], to = faces.number[cut.node[next_in_triangle(halfedge)]];
  if (!ascending) std::swap(from, to);
  TColStd_Array1OfInteger nodes(1, 2);
  nodes(1) = from;
  nodes(2) = to;
  TColStd_Array1OfReal parameters(1, 2);
  parameters(1) = 0;
  parameters(2) = length;
  return new Poly_PolygonOnTriangulation(nodes, parameters);
}

/// Adds one edge of the shape for one or two half-edges between the same vertices.
void add_edge(Faces& faces, const TriangleMesh& mesh, const Patches& cut, const std::array<int, 2>& vertex,
              std::span<const int> halfedges) {
  static const Handle(Geom2d_Line) in_parameters = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(1, 0));
  const BRep_Builder builder;
  const Vec3 &a = mesh.points[vertex[0]], &b = mesh.points[vertex[1]];
  const Vec3 d = b - a;
  const double length = glm::length(d);
  if (length <= gp::Resolution()) return;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, new Geom_Line(gp_Pnt(a.x, a.y, a.z), gp_Dir(d.x, d.y, d.z)), 1e-7);
  builder.Range(edge, 0, length);
  builder.UpdateEdge(edge, in_parameters, Handle(Geom_Surface)(), TopLoc_Location(), 1e-7);

  std::array<Handle(Poly_PolygonOnTriangulation), 2> polygons;
  for (std::size_t i = 0; i < halfedges.size(); ++i)
    polygons[i] = polygon_of(faces, cut, halfedges[i], mesh.corners[halfedges[i]] == vertex[0], length);
  const auto patch = [&](std::size_t i) { return cut.patch[halfedges[i] / 3]; };
  const bool seam = halfedges.size() == 2 && patch(0) == patch(1);
  if (seam)
    builder.UpdateEdge(edge, polygons[0], polygons[1], faces.triangulations[patch(0)]);
  else
    for (std::size_t i = 0; i < halfedges.size(); ++i)
      builder.UpdateEdge(edge, polygons[i], faces.triangulations[patch(i)]);
  for (std::size_t i = 0; i < halfedges.size(); ++i)
    builder.Add(faces.rims[patch(i)], edge.Oriented(i == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
}

void add_edges(Faces& faces, const TriangleMesh& mesh, const Patches& cut) {
  for (std::size_t e = 0; e < cut.rim.size(); ++e) {
    if (cut.rim[e] == 0) continue;
    const MeshEdge& edge = cut.table.edges[e];
    const std::span<const int> halfedges = cut.table.halfedges_of(edge);
    if (is_two_sided(cut.table, edge, mesh.corners))
      add_edge(faces, mesh, cut, edge.vertex, halfedges);
    else  // an edge of more than two faces would be omitted
      for (std::size_t i = 0; i < halfedges.size(); ++i)
        add_edge(faces, mesh, cut, edge.vertex, halfedges.subspan(i, 1));
  }
}

std::vector<TopoDS_Shell> shells_of(Faces& faces, const Patches& cut) {
  const BRep_Builder builder;
  std::vector<TopoDS_Shell> shells(cut.closed.size());
  for (TopoDS_Shell& shell : shells) builder.MakeShell(shell);
  std::vector<char> done(faces.faces.size(), 0);
  for (std::size_t t = 0; t < cut.patch.size(); ++t) {
    const int patch = cut.patch[t];
    if (std::exchange(done[patch], 1) != 0) continue;
    builder.Add(faces.faces[patch], faces.rims[patch]);
    builder.Add(shells[cut.shell[t]], faces.faces[patch]);
  }
  for (std::size_t s = 0; s < shells.size(); ++s) shells[s].Closed(cut.closed[s] != 0);
  return shells;
}

Drawn segments_of(HLRBRep_PolyAlgo& algorithm) {
  Drawn drawn;
  HLRAlgo_EdgeStatus status;
  HLRAlgo_EdgeIterator spans;
  TopoDS_Shape shape;
  Standard_Boolean smooth = false, very_smooth = false, outline = false, internal = false;
  Standard_Real begin = 0, end = 0;
  Standard_ShortReal begin_tolerance = 0, end_tolerance = 0;
  for (algorithm.InitHide(); algorithm.MoreHide(); algorithm.NextHide()) {
    const auto& points = algorithm.Hide(status, shape, smooth, very_smooth, outline, internal);
    const Vec2 a(points.Pnt1.X(), points.Pnt1.Y()), d = Vec2(points.Pnt2.X(), points.Pnt2.Y()) - a;
    if (glm::length(d) <= 1e-10) continue;
    for (spans.InitVisible(status); spans.MoreVisible(); spans.NextVisible()) {
      spans.Visible(begin, begin_tolerance, end, end_tolerance);
      drawn.visible.push_back({a + begin * d, a + end * d});
    }
    for (spans.InitHidden(status); spans.MoreHidden(); spans.NextHidden()) {
      spans.Hidden(begin, begin_tolerance, end, end_tolerance);
      drawn.hidden.push_back({a + begin * d, a + end * d});
    }
  }
  return drawn;
}

}  // namespace

Drawn remove_hidden_lines(const TriangleMesh& mesh, double crease_angle) {
  const Patches cut = cut_along_creases(mesh, crease_angle);
  Faces faces = empty_faces(cut);
  fill_triangulations(faces, mesh, cut);
  add_edges(faces, mesh, cut);
  const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo();
  for (const TopoDS_Shell& shell : shells_of(faces, cut)) algorithm->Load(shell);
  algorithm->Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0))));
  algorithm->Update();
  return segments_of(*algorithm);
}

}  // namespace epura::bench
