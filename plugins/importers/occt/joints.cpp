// SPDX-License-Identifier: Apache-2.0
#include "joints.hpp"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace occt {

namespace {

constexpr double tangent_angle = 1;         // degrees: edges called smooth in BRep files are rarely exactly smooth
constexpr double believable_tangency = 10;  // degrees: a file that calls more than this smooth is wrong
constexpr int samples = 9;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One of the faces at an edge.
class Side {
 public:
  Side(const TopoDS_Edge& edge, const TopoDS_Face& face)
      : face_(face), surface_(face, /*Restriction=*/false), orientation_(orientation(edge, face)) {
    curve_ = BRep_Tool::CurveOnSurface(edge, face, first_, last_);
    const bool is_mirrored = surface_.Trsf().IsNegative();
    sign_ = (face.Orientation() == TopAbs_REVERSED) != is_mirrored ? -1 : 1;
  }

  /// Its outward normal; at poles, the normal at a point close by.
  [[nodiscard]] std::optional<gp_Vec> normal(double share) const {
    if (curve_.IsNull()) return std::nullopt;
    const gp_XY place = curve_->Value(first_ + share * (last_ - first_)).XY();
    if (const auto found = normal_at(place)) return found;
    std::array<double, 4> range{};
    BRepTools::UVBounds(face_, range[0], range[1], range[2], range[3]);
    const gp_XY middle((range[0] + range[1]) / 2, (range[2] + range[3]) / 2);
    const auto near = normal_at(place + 1e-4 * (middle - place));
    return near ? near : normal_at(place + 1e-2 * (middle - place));
  }

  /// In a shell of consistently oriented faces, the edge has the opposite direction on the other side.
  [[nodiscard]] bool agrees_with(const Side& other) const { return orientation_ != other.orientation_; }

 private:
  static TopAbs_Orientation orientation(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
      if (edges.Current().IsSame(edge)) return edges.Current().Orientation();
    return TopAbs_EXTERNAL;
  }

  [[nodiscard]] std::optional<gp_Vec> normal_at(const gp_XY& place) const {
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface_.D1(place.X(), place.Y(), point, along_u, along_v);
    const gp_Vec across = along_u.Crossed(along_v);
    const double size = across.Magnitude();
    if (!(size > 1e-9 * (along_u.SquareMagnitude() + along_v.SquareMagnitude()))) return std::nullopt;
    return across * (sign_ / size);
  }

  TopoDS_Face face_;
  BRepAdaptor_Surface surface_;
  TopAbs_Orientation orientation_;
  Handle(Geom2d_Curve) curve_;
  double first_ = 0, last_ = 0, sign_ = 1;
};

double degrees_between(const gp_Vec& a, const gp_Vec& b) {
  return std::atan2(a.Crossed(b).Magnitude(), a.Dot(b)) * 180 / std::numbers::pi;
}

double angle_along(const Side& one, const Side& other) {
  std::vector<double> angles;
  const double sign = one.agrees_with(other) ? 1 : -1;
  for (int i = 1; i <= samples; ++i) {
    const double share = static_cast<double>(i) / (samples + 1);
    const auto a = one.normal(share), b = other.normal(share);
    if (a && b) angles.push_back(degrees_between(*a, *b * sign));
  }
  if (angles.empty()) return unknown;
  // A single sample may be at a flaw.
  const auto place = angles.begin() + static_cast<std::ptrdiff_t>(9 * (angles.size() - 1) / 10);
  std::nth_element(angles.begin(), place, angles.end());
  return *place;
}

Joint joint_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces) {
  if (faces.Extent() > 2) return {edge, {}, false, unknown};
  const TopoDS_Face& one = TopoDS::Face(faces.First());
  const TopoDS_Face& other = TopoDS::Face(faces.Last());
  const double angle = angle_along(Side(edge, one), Side(edge, other));
  const bool is_declared = BRep_Tool::Continuity(edge, one, other) >= GeomAbs_G1;
  return {edge, {}, angle <= tangent_angle || (is_declared && !(angle > believable_tangency)), angle};
}

}  // namespace

std::vector<Joint> joints_of(const BodyMesh& mesh) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_at;
  for (const Facets& facets : mesh.faces) {
    for (TopExp_Explorer edges(facets.face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Shape& edge = edges.Current();
      int index = faces_at.FindIndex(edge);
      if (index == 0) index = faces_at.Add(edge, TopTools_ListOfShape());
      TopTools_ListOfShape& faces = faces_at.ChangeFromIndex(index);
      // Seams appear twice in one face.
      if (faces.IsEmpty() || !faces.Last().IsSame(facets.face)) faces.Append(facets.face);
    }
  }
  std::vector<Joint> joints;
  for (int i = 1; i <= faces_at.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(faces_at.FindKey(i).Oriented(TopAbs_FORWARD));
    const Along* along = mesh.edges.Seek(edge);
    if (faces_at(i).Extent() < 2 || along == nullptr || BRep_Tool::Degenerated(edge)) continue;
    Joint joint = joint_of(edge, faces_at(i));
    joint.along = *along;
    joints.push_back(std::move(joint));
  }
  return joints;
}

}  // namespace occt
