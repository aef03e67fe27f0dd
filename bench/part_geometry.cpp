// SPDX-License-Identifier: Apache-2.0
#include "part_geometry.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <Geom2d_Curve.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gp_Ax2.hxx>
#include <numbers>

#include "base/file.hpp"
#include "base/temporary_folder.hpp"
#include "mesh/weld.hpp"

namespace epura::bench {

namespace {

constexpr double facet_angle = 0.35;                          // radians between facets, as set by exporters
constexpr double tangent_angle = 5 * std::numbers::pi / 180;  // exporters are not precise

double diagonal_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  if (box.IsVoid()) throw Standard_Failure("the part is empty");
  return std::sqrt(box.SquareExtent());
}

/// Every triangle has separate corners.
void add_face(Polygons& soup, const TopoDS_Face& face) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
  if (triangulation.IsNull()) return;
  const auto stored = [](double coordinate) { return static_cast<double>(static_cast<float>(coordinate)); };
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    std::array<int, 3> nodes{};
    triangulation->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(nodes[1], nodes[2]);
    for (const int node : nodes) {
      const gp_Pnt p = triangulation->Node(node).Transformed(place.Transformation());
      soup.points.push_back({stored(p.X()), stored(p.Y()), stored(p.Z())});
    }
    const int end = static_cast<int>(soup.points.size());
    soup.faces.push_back({end - 3, end - 2, end - 1});
  }
}

/// In the same way as the STL reader, including the order of points: coincident points are merged.
void weld(Polygons& soup) {
  std::vector<int> corners;
  for (const std::vector<int>& face : soup.faces) corners.insert(corners.end(), face.begin(), face.end());
  mesh::renumber(soup.points, corners, mesh::same_places(soup.points));
  soup.single_precision = true;
  for (std::size_t i = 0; i < soup.faces.size(); ++i)
    std::copy_n(corners.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, soup.faces[i].begin());
}

/// Nothing if the surface has no normal, as at the apex of a cone.
std::optional<gp_Vec> normal_at(const TopoDS_Edge& edge, const TopoDS_Face& face, double share) {
  double from = 0, to = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
  if (curve.IsNull()) return std::nullopt;
  const gp_Pnt2d p = curve->Value(from + (to - from) * share);
  BRepLProp_SLProps properties(BRepAdaptor_Surface(face), p.X(), p.Y(), 1, 1e-9);
  if (!properties.IsNormalDefined()) return std::nullopt;
  const gp_Vec normal = properties.Normal();
  return face.Orientation() == TopAbs_REVERSED ? normal.Reversed() : normal;
}

bool are_tangent(const TopoDS_Edge& edge, const std::array<TopoDS_Face, 2>& faces) {
  constexpr int steps = 12;
  bool any = false;
  for (int k = 1; k < steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const auto normal = normal_at(edge, faces[0], share), other = normal_at(edge, faces[1], share);
    if (!normal || !other) continue;
    if (normal->Angle(*other) >= tangent_angle) return false;
    any = true;
  }
  return any;
}

class Curves {
 public:
  Curves(double deflection, double angle) : deflection_(deflection), angle_(angle) {}

  /// Appends the edges as polylines.
  void append(std::vector<PlaneLine>& lines, const TopoDS_Shape& edges) {
    if (edges.IsNull()) return;
    BRepLib::BuildCurves3d(edges);
    for (TopExp_Explorer edge(edges, TopAbs_EDGE); edge.More(); edge.Next()) {
      try {
        const GCPnts_TangentialDeflection points(BRepAdaptor_Curve(TopoDS::Edge(edge.Current())), angle_, deflection_,
                                                 2, 1e-9);
        for (int i = 1; i < points.NbPoints(); ++i) {
          const gp_Pnt a = points.Value(i), b = points.Value(i + 1);
          lines.push_back({Vec2(a.X(), a.Y()), Vec2(b.X(), b.Y())});
        }
      } catch (const Standard_Failure&) {
        ++lost_;
      }
    }
  }

  [[nodiscard]] int lost() const { return lost_; }

 private:
  double deflection_, angle_;
  int lost_ = 0;
};

gp_Ax2 axes_of(const Vec3& viewer) {
  const gp_Dir normal(viewer.x, viewer.y, viewer.z), z(0, 0, 1);
  return {gp_Pnt(0, 0, 0), normal, (normal.IsParallel(z, 1e-6) ? gp_Dir(0, 1, 0) : z).Crossed(normal)};
}

/// Adds each body once, and faces that belong to none.
void add_bodies(HLRBRep_Algo& algorithm, const TopoDS_Shape& shape) {
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) algorithm.Add(solid.Current(), 0);
  for (TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
    algorithm.Add(shell.Current(), 0);
  for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
    algorithm.Add(face.Current(), 0);
}

}  // namespace

Polygons tessellate(const TopoDS_Shape& part, double fineness) {
  BRepTools::Clean(part);  // files may have their own triangles
  const BRepMesh_IncrementalMesh mesher(part, diagonal_of(part) / fineness, /*isRelative=*/false, facet_angle);
  Polygons polygons;
  for (TopExp_Explorer face(part, TopAbs_FACE); face.More(); face.Next())
    add_face(polygons, TopoDS::Face(face.Current()));
  BRepTools::Clean(part);
  weld(polygons);
  polygons.single_precision = true;
  return polygons;
}

std::optional<std::string> stl_by_gmsh(const TopoDS_Shape& part, int around) {
  const TemporaryFolder folder;
  const std::string shape = (folder / "part.brep").string(), triangles = (folder / "part.stl").string();
  if (!BRepTools::Write(part, shape.c_str())) throw Standard_Failure("the part cannot be written");
  const std::string command = "gmsh '" + shape + "' -2 -v 0 -bin -o '" + triangles +
                              "' -setnumber Mesh.MeshSizeExtendFromBoundary 0 -setnumber Mesh.MeshSizeFromCurvature " +
                              std::to_string(around) + " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return std::nullopt;
  return read_file(triangles);
}

void mark_tangent_edges(const TopoDS_Shape& shape) {
  BRepLib::EncodeRegularity(shape, tangent_angle);
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int i = 1; i <= faces_of.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
    if (BRep_Tool::Degenerated(edge) || faces_of(i).Extent() != 2) continue;
    const std::array faces{TopoDS::Face(faces_of(i).First()), TopoDS::Face(faces_of(i).Last())};
    if (faces[0].IsSame(faces[1]) || BRep_Tool::Continuity(edge, faces[0], faces[1]) != GeomAbs_C0) continue;
    if (are_tangent(edge, faces)) BRep_Builder().Continuity(edge, faces[0], faces[1], GeomAbs_G1);
  }
}

HLRAlgo_Projector projector_of(const Vec3& viewer, double eye) {
  const gp_Ax2 axes = axes_of(viewer);
  return eye > 0 ? HLRAlgo_Projector(axes, eye) : HLRAlgo_Projector(axes);
}

ExactView exact_view(const TopoDS_Shape& part, const Vec3& viewer, double fineness, double eye) {
  const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo();
  add_bodies(*algorithm, part);
  algorithm->Projector(projector_of(viewer, eye));
  algorithm->Update();
  algorithm->Hide();

  HLRBRep_HLRToShape found(algorithm);
  Curves curves(diagonal_of(part) / fineness, 3 / std::sqrt(fineness));
  const gp_Dir right = axes_of(viewer).XDirection(), up = axes_of(viewer).YDirection();
  ExactView view{{right.X(), right.Y(), right.Z()}, {up.X(), up.Y(), up.Z()}, {}, {}, {}, {}, 0};
  for (const TopoDS_Shape& edges : {found.VCompound(), found.OutLineVCompound()}) curves.append(view.visible, edges);
  for (const TopoDS_Shape& edges : {found.HCompound(), found.OutLineHCompound()}) curves.append(view.hidden, edges);
  for (const TopoDS_Shape& edges : {found.Rg1LineVCompound(), found.RgNLineVCompound()})
    curves.append(view.smooth_visible, edges);
  for (const TopoDS_Shape& edges : {found.Rg1LineHCompound(), found.RgNLineHCompound()})
    curves.append(view.smooth_hidden, edges);
  view.lost = curves.lost();
  return view;
}

}  // namespace epura::bench
