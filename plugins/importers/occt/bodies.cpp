// SPDX-License-Identifier: Apache-2.0
#include "bodies.hpp"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

namespace occt {

namespace {

/// Gaps that other programs leave between faces, relative to the diagonal; well below anything visible in a drawing.
constexpr double relative_gap = 2e-5;
constexpr double min_gap = 1e-5, max_gap = 0.05;  // mm

std::vector<TopoDS_Shape> all(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum avoided) {
  std::vector<TopoDS_Shape> found;
  for (TopExp_Explorer each(shape, kind, avoided); each.More(); each.Next()) found.push_back(each.Current());
  return found;
}

TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

double gap_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return box.IsVoid() ? min_gap : std::clamp(relative_gap * std::sqrt(box.SquareExtent()), min_gap, max_gap);
}

/// Orients a closed shell so that the outside is known, which loose faces do not tell. Nothing if it is not closed,
/// whatever it says: Open CASCADE then throws.
std::optional<TopoDS_Shape> closed_as_solid(const TopoDS_Shape& shell) {
  if (!BRep_Tool::IsClosed(shell)) return std::nullopt;
  try {
    TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell)).Solid();
    return BRepLib::OrientClosedSolid(solid) ? TopoDS_Shape(solid) : shell;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

void append(std::vector<TopoDS_Shape>& to, const std::vector<TopoDS_Shape>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

bool has_face(const TopoDS_Shape& shape) { return TopExp_Explorer(shape, TopAbs_FACE).More(); }

std::size_t count_degenerate_edges(const TopoDS_Shape& shape) {
  const std::vector<TopoDS_Shape> edges = all(shape, TopAbs_EDGE, TopAbs_SHAPE);
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const TopoDS_Shape& edge) { return BRep_Tool::Degenerated(TopoDS::Edge(edge)); }));
}

/// Returns shells and faces; none if a face was lost, or an edge: edges that do not end in their vertices collapse.
std::vector<TopoDS_Shape> sew(const std::vector<TopoDS_Shape>& pieces, std::size_t face_count) {
  const TopoDS_Compound together = compound_of(pieces);
  BRepBuilderAPI_Sewing sewing(gap_of(together));
  sewing.Add(together);
  sewing.Perform();
  const TopoDS_Shape& sewn = sewing.SewedShape();
  if (sewn.IsNull() || all(sewn, TopAbs_FACE, TopAbs_SHAPE).size() != face_count ||
      count_degenerate_edges(sewn) > count_degenerate_edges(together))
    return {};
  std::vector<TopoDS_Shape> found = all(sewn, TopAbs_FACE, TopAbs_SHELL);
  append(found, all(sewn, TopAbs_SHELL, TopAbs_SOLID));
  return found;
}

}  // namespace

Bodies bodies_of(const TopoDS_Shape& shape) {
  Bodies bodies;
  for (const TopoDS_Shape& solid : all(shape, TopAbs_SOLID, TopAbs_SHAPE))
    if (has_face(solid)) bodies.closed.push_back(solid);
  bodies.solids = bodies.closed.size();
  std::vector<TopoDS_Shape> open = all(shape, TopAbs_FACE, TopAbs_SHELL);
  std::size_t face_count = open.size();
  for (const TopoDS_Shape& shell : all(shape, TopAbs_SHELL, TopAbs_SOLID)) {
    if (!has_face(shell)) continue;
    if (const auto closed = closed_as_solid(shell)) {
      bodies.closed.push_back(*closed);
      continue;
    }
    open.push_back(shell);
    face_count += all(shell, TopAbs_FACE, TopAbs_SHAPE).size();
  }
  const std::vector<TopoDS_Shape> sewn = open.size() > 1 ? sew(open, face_count) : std::vector<TopoDS_Shape>();
  if (!sewn.empty() && sewn.size() < open.size()) {
    bodies.loose = open.size();
    bodies.sewn_into = sewn.size();
    open = sewn;
  }
  std::vector<TopoDS_Shape> faces;
  for (const TopoDS_Shape& piece : open) {
    if (piece.ShapeType() != TopAbs_SHELL)
      faces.push_back(piece);
    else if (const auto closed = closed_as_solid(piece))
      bodies.closed.push_back(*closed);
    else
      bodies.open.push_back(piece);
  }
  if (!faces.empty()) bodies.open.push_back(compound_of(faces));
  return bodies;
}

Company company_in(const TopoDS_Shape& shape) {
  const std::vector<TopoDS_Shape> shells = all(shape, TopAbs_SHELL, TopAbs_SOLID);
  return {
      TopExp_Explorer(shape, TopAbs_SOLID).More(),
      std::any_of(shells.begin(), shells.end(), [](const TopoDS_Shape& shell) { return BRep_Tool::IsClosed(shell); })};
}

}  // namespace occt
