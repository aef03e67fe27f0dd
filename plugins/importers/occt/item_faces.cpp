// SPDX-License-Identifier: Apache-2.0
#include "item_faces.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_BoundSortBox.hxx>
#include <Bnd_Box.hxx>
#include <Bnd_HArray1OfBox.hxx>
#include <Precision.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Curve.hxx>
#include <StepShape_BrepWithVoids.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_Edge.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_VertexPoint.hxx>
#include <TColStd_ListIteratorOfListOfInteger.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "placements.hpp"
#include "readers.hpp"

namespace occt {

namespace {

using Number = unsigned long long;

/// What items can be, by their numbers in the file.
struct Items {
  std::map<Number, TopoDS_Shape> faces;
  std::map<Number, std::set<Number>> beside;     ///< of an edge: the faces that it bounds
  std::map<Number, gp_Ax2> places;               ///< in the unit of the file
  std::map<Number, TopoDS_Edge> lines;           ///< beside solids
  std::map<Number, std::array<gp_XYZ, 2>> ends;  ///< of edges, in the unit of the file
  std::map<Number, TopoDS_Edge> edges;           ///< of solids, as far as they are known
  std::map<Number, std::vector<Number>> bodies;  ///< faces of each solid
};

void add_edges(const StepShape_FaceSurface& face, Number number, const StepData_StepModel& model, Items& items) {
  for (int i = 1; i <= face.NbBounds(); ++i) {
    const auto loop = Handle(StepShape_EdgeLoop)::DownCast(face.BoundsValue(i)->Bound());
    for (int k = 1; !loop.IsNull() && k <= loop->NbEdgeList(); ++k)
      items.beside[static_cast<Number>(model.IdentLabel(loop->EdgeListValue(k)->EdgeElement()))].insert(number);
  }
}

// Of its outer shell and its cavities.
std::vector<Number> faces_of(const StepShape_ManifoldSolidBrep& solid, const StepData_StepModel& model) {
  std::vector<Number> faces;
  const auto add_shell = [&](const Handle(StepShape_ConnectedFaceSet) & shell) {
    for (int i = 1; !shell.IsNull() && i <= shell->NbCfsFaces(); ++i)
      faces.push_back(static_cast<Number>(model.IdentLabel(shell->CfsFacesValue(i))));
  };
  add_shell(solid.Outer());
  if (const auto* hollow = dynamic_cast<const StepShape_BrepWithVoids*>(&solid))
    for (int i = 1; i <= hollow->NbVoids(); ++i) add_shell(hollow->VoidsValue(i)->ClosedShellElement());
  return faces;
}

// A point has the axes of space.
std::optional<gp_Ax2> place_of(const Handle(Standard_Transient) & entity) {
  if (const auto placement = Handle(StepGeom_Axis2Placement3d)::DownCast(entity); !placement.IsNull())
    return axes_of(placement);
  const auto point = triple(Handle(StepGeom_CartesianPoint)::DownCast(entity));
  return point ? std::optional(gp_Ax2(gp_Pnt(*point), gp::DZ(), gp::DX())) : std::nullopt;
}

std::optional<gp_XYZ> point_of(const Handle(StepShape_Vertex) & vertex) {
  const auto point = Handle(StepShape_VertexPoint)::DownCast(vertex);
  return point.IsNull() ? std::nullopt : triple(Handle(StepGeom_CartesianPoint)::DownCast(point->VertexGeometry()));
}

// `wanted` are the numbers that requirements name: places are many in a file.
Items items_of(const STEPControl_Reader& reader, const std::set<Number>& wanted) {
  const Handle(StepData_StepModel) model = reader.StepModel();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  Items items;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    const auto number = static_cast<Number>(model->IdentLabel(entity));
    if (const auto face = Handle(StepShape_FaceSurface)::DownCast(entity); !face.IsNull()) {
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process, face);
      if (shape.IsNull()) continue;
      items.faces.emplace(number, shape);
      add_edges(*face, number, *model, items);
    } else if (const auto solid = Handle(StepShape_ManifoldSolidBrep)::DownCast(entity); !solid.IsNull()) {
      items.bodies.emplace(number, faces_of(*solid, *model));
    } else if (wanted.count(number) != 0) {
      if (const auto place = place_of(entity)) items.places.emplace(number, *place);
      if (const TopoDS_Shape edge = TransferBRep::ShapeResult(process, entity);
          !edge.IsNull() && edge.ShapeType() == TopAbs_EDGE)
        items.edges.emplace(number, TopoDS::Edge(edge));
      if (const auto edge = Handle(StepShape_Edge)::DownCast(entity); !edge.IsNull())
        if (const auto from = point_of(edge->EdgeStart()), to = point_of(edge->EdgeEnd()); from && to)
          items.ends.emplace(number, std::array{*from, *to});
      if (const auto curve = Handle(StepGeom_Curve)::DownCast(entity); !curve.IsNull())
        if (const TopoDS_Shape line = TransferBRep::ShapeResult(process, curve);
            !line.IsNull() && line.ShapeType() == TopAbs_EDGE)
          items.lines.emplace(number, TopoDS::Edge(line));
    }
  }
  return items;
}

// Of planes and cylinders; none if they are neither, or stand askew.
std::optional<double> distance_between(const TopoDS_Shape& one, const TopoDS_Shape& other) {
  if (one.ShapeType() != TopAbs_FACE || other.ShapeType() != TopAbs_FACE) return std::nullopt;
  const BRepAdaptor_Surface a(TopoDS::Face(one)), b(TopoDS::Face(other));
  const bool a_is_plane = a.GetType() == GeomAbs_Plane, b_is_plane = b.GetType() == GeomAbs_Plane;
  if ((!a_is_plane && a.GetType() != GeomAbs_Cylinder) || (!b_is_plane && b.GetType() != GeomAbs_Cylinder))
    return std::nullopt;
  const gp_Ax1 along_a = a_is_plane ? a.Plane().Axis() : a.Cylinder().Axis();
  const gp_Ax1 along_b = b_is_plane ? b.Plane().Axis() : b.Cylinder().Axis();
  const gp_Dir &u = along_a.Direction(), &v = along_b.Direction();
  const bool is_square = a_is_plane != b_is_plane;  // an axis lies along a plane
  if (is_square ? !u.IsNormal(v, Precision::Angular()) : !u.IsParallel(v, Precision::Angular())) return std::nullopt;
  const gp_Vec between(along_a.Location(), along_b.Location());
  if (a_is_plane || b_is_plane) return std::abs(between.Dot(gp_Vec(a_is_plane ? u : v)));
  return between.Crossed(gp_Vec(u)).Magnitude();
}

class FaceFinder {
 public:
  explicit FaceFinder(Items items) : items_(std::move(items)) {}

  // Returns how many items stand for no face.
  std::size_t find(Requirement& requirement) {
    std::size_t lost = 0;
    const bool is_distance = add_apart(requirement), is_between_lines = add_lines(requirement);
    for (const Number item : requirement.items) {
      if (is_distance || add_body(item, requirement)) continue;
      std::size_t before = requirement.faces.size();
      if (const auto face = items_.faces.find(item); face != items_.faces.end())
        requirement.faces.push_back(face->second);
      else if (means_edge(requirement) && items_.ends.count(item) != 0)
        add_edge(item, requirement);
      else if (const auto edge = items_.beside.find(item); edge != items_.beside.end() && means_axis(requirement))
        add_cylinder(edge->second, requirement);
      else if (const auto place = items_.places.find(item); place != items_.places.end())
        add_below_place(place->second, requirement);
      else if (const auto line = items_.lines.find(item);
               line != items_.lines.end() && (is_between_lines || requirement.kind == EPURA_TOLERANCE))
        add_below_line(line->second, requirement);
      lost += requirement.faces.size() == before ? 1 : 0;
    }
    return lost;
  }

 private:
  // Form tolerances and runouts of an edge mean the edge.
  static bool means_axis(const Requirement& requirement) {
    constexpr std::array<std::string_view, 4> of_axes{"position", "coaxiality", "concentricity", "symmetry"};
    return requirement.kind == EPURA_DIMENSION || requirement.kind == EPURA_DATUM ||
           std::find(of_axes.begin(), of_axes.end(), requirement.type) != of_axes.end();
  }

  static bool means_edge(const Requirement& requirement) {
    if (requirement.kind == EPURA_DIMENSION) return requirement.type.find("curve") != std::string::npos;
    return requirement.kind != EPURA_DATUM && !means_axis(requirement);
  }

  // What holds for a body holds all over it; for the only one, all over the part. Sizes and datums are of faces.
  bool add_body(Number item, Requirement& requirement) const {
    const auto body = items_.bodies.find(item);
    const bool may_be = requirement.kind != EPURA_DIMENSION && requirement.kind != EPURA_DATUM;
    if (body == items_.bodies.end() || !may_be) return false;
    if (requirement.kind == EPURA_TOLERANCE)
      requirement.modifiers += (requirement.modifiers.empty() ? "" : ", ") + std::string("all over");
    if (items_.bodies.size() == 1) return true;
    for (const Number face : body->second)
      if (const auto known = items_.faces.find(face); known != items_.faces.end())
        requirement.faces.push_back(known->second);
    return true;
  }

  [[nodiscard]] std::set<Number> candidates(Number item) const {
    if (items_.faces.count(item) != 0) return {item};
    const auto edge = items_.beside.find(item);
    return edge == items_.beside.end() ? std::set<Number>() : edge->second;
  }

  bool add_apart(Requirement& requirement) const {
    const std::vector<Number>& two = requirement.items;
    if (requirement.kind != EPURA_DIMENSION || requirement.is_angle || two.size() != 2) return false;
    if (items_.beside.count(two[0]) == 0 && items_.beside.count(two[1]) == 0) return false;
    std::vector<std::pair<Number, Number>> apart;
    for (const Number one : candidates(two[0]))
      for (const Number other : candidates(two[1]))
        if (const auto distance = distance_between(items_.faces.at(one), items_.faces.at(other));
            distance && *distance > Precision::Confusion())
          apart.emplace_back(one, other);
    if (apart.size() != 1) return false;
    requirement.faces = {items_.faces.at(apart[0].first), items_.faces.at(apart[0].second)};
    return true;
  }

  // It is between faces. A curve has two lines, which meet in its middle.
  void add_edge(Number item, Requirement& requirement) const {
    const auto beside = items_.beside.find(item);
    if (beside == items_.beside.end() || std::isnan(requirement.length_unit)) return;
    for (const Number number : beside->second) requirement.faces.push_back(items_.faces.at(number));
    const std::array<gp_XYZ, 2>& ends = items_.ends.at(item);
    const gp_XYZ from = ends[0] * requirement.length_unit, to = ends[1] * requirement.length_unit;
    const auto edge = items_.edges.find(item);
    if (edge == items_.edges.end()) return add_line(from, to, requirement);
    const BRepAdaptor_Curve curve(edge->second);
    if (curve.GetType() == GeomAbs_Line) return add_line(from, to, requirement);
    const gp_XYZ middle = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2).XYZ();
    add_line(from, middle, requirement);
    add_line(middle, to, requirement);
  }

  static void add_line(const gp_XYZ& from, const gp_XYZ& to, Requirement& requirement) {
    requirement.lines.push_back({from.X(), from.Y(), from.Z(), to.X(), to.Y(), to.Z()});
  }

  void add_cylinder(const std::set<Number>& beside, Requirement& requirement) const {
    std::vector<TopoDS_Shape> cylinders;
    for (const Number number : beside)
      if (const TopoDS_Shape& face = items_.faces.at(number);
          face.ShapeType() == TopAbs_FACE && BRepAdaptor_Surface(TopoDS::Face(face)).GetType() == GeomAbs_Cylinder)
        cylinders.push_back(face);
    if (cylinders.size() == 1) requirement.faces.push_back(cylinders.front());
  }

  // A dimension between straight lines; one of them alone has a length.
  bool add_lines(Requirement& requirement) const {
    if (requirement.kind != EPURA_DIMENSION || requirement.is_angle || requirement.items.size() != 2) return false;
    for (const Number item : requirement.items) {
      const auto line = items_.lines.find(item);
      if (line == items_.lines.end()) return false;
      const BRepAdaptor_Curve curve(line->second);
      if (curve.GetType() != GeomAbs_Line || Precision::IsInfinite(curve.FirstParameter()) ||
          Precision::IsInfinite(curve.LastParameter()))
        return false;
    }
    for (const Number item : requirement.items) {
      const BRepAdaptor_Curve curve(items_.lines.at(item));
      add_line(curve.Value(curve.FirstParameter()).XYZ(), curve.Value(curve.LastParameter()).XYZ(), requirement);
    }
    return true;
  }

  // Its length is along the first axis of its place, its width along the second one.
  void add_below_place(const gp_Ax2& place, Requirement& requirement) {
    if (std::isnan(requirement.length_unit)) return;
    const gp_XYZ at = place.Location().XYZ() * requirement.length_unit;
    add_below({gp_Pnt(at)}, requirement);
    if (requirement.type == "datum target")
      requirement.area = {at, place.XDirection().XYZ() * (requirement.target_length / 2),
                          place.YDirection().XYZ() * (requirement.target_width / 2)};
  }

  // A line on a face is one of its elements: three points of it are on the face.
  void add_below_line(const TopoDS_Edge& line, Requirement& requirement) {
    const BRepAdaptor_Curve curve(line);
    const double from = curve.FirstParameter(), to = curve.LastParameter();
    if (Precision::IsInfinite(from) || Precision::IsInfinite(to)) return;
    add_below({curve.Value(from), curve.Value((from + to) / 2), curve.Value(to)}, requirement);
  }

  // The only face on which all the points are, in millimetres.
  void add_below(const std::vector<gp_Pnt>& points, Requirement& requirement) {
    if (items_.faces.empty()) return;
    if (boxed_.empty()) find_boxes();
    Bnd_Box around;
    for (const gp_Pnt& point : points) around.Add(point);
    std::vector<TopoDS_Shape> below;
    for (TColStd_ListIteratorOfListOfInteger at(boxes_.Compare(around)); at.More(); at.Next()) {
      const TopoDS_Shape& face = boxed_[static_cast<std::size_t>(at.Value() - 1)];
      if (std::all_of(points.begin(), points.end(), [&face](const gp_Pnt& point) { return is_on(point, face); }))
        below.push_back(face);
    }
    if (below.size() == 1) requirement.faces.push_back(below.front());
  }

  static bool is_on(const gp_Pnt& point, const TopoDS_Shape& face) {
    const BRepExtrema_DistShapeShape distance(BRepBuilderAPI_MakeVertex(point), face);
    return distance.IsDone() && distance.Value() <= BRep_Tool::MaxTolerance(face, TopAbs_FACE);
  }

  void find_boxes() {
    std::vector<Bnd_Box> boxes;
    for (const auto& [number, face] : items_.faces) {
      BRepBndLib::Add(face, boxes.emplace_back());
      boxed_.push_back(face);
    }
    const Handle(Bnd_HArray1OfBox) all = new Bnd_HArray1OfBox(1, static_cast<int>(boxes.size()));
    for (std::size_t i = 0; i < boxes.size(); ++i) all->SetValue(static_cast<int>(i) + 1, boxes[i]);
    boxes_.Initialize(all);
  }

  const Items items_;
  std::vector<TopoDS_Shape> boxed_{};  ///< faces, in the order of their boxes; empty until a place is looked for
  Bnd_BoundSortBox boxes_{};
};

}  // namespace

void find_faces(std::vector<Requirement>& requirements, const STEPControl_Reader& reader) {
  std::set<Number> wanted;
  for (const Requirement& requirement : requirements) wanted.insert(requirement.items.begin(), requirement.items.end());
  if (wanted.empty()) return;
  FaceFinder finder(items_of(reader, wanted));
  for (Requirement& requirement : requirements)
    if (const std::size_t lost = finder.find(requirement); lost > 0)
      requirement.missing += (requirement.missing.empty() ? "" : ", ") + counted(lost, "item") + " without a face";
}

}  // namespace occt
