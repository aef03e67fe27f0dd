// SPDX-License-Identifier: Apache-2.0
#include "turning_edges.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <IMeshData_Edge.hxx>
#include <IMeshData_Face.hxx>
#include <IMeshData_Model.hxx>
#include <IMeshData_PCurve.hxx>
#include <IMeshTools_CurveTessellator.hxx>
#include <IMeshTools_Parameters.hxx>
#include <OSD_Parallel.hxx>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "tessellation.hpp"

namespace occt {

namespace {

/// How fine an edge has to be.
struct Fine {
  double deflection;  ///< mm
  double angle;       ///< radians
};

// Halvings of a piece of an edge, where its parameters say nothing of its length.
constexpr int most_halvings = 12;

/// The points of an edge at given parameters.
class AtParameters : public IMeshTools_CurveTessellator {
  DEFINE_STANDARD_RTTI_INLINE(AtParameters, IMeshTools_CurveTessellator)

 public:
  AtParameters(const TopoDS_Edge& edge, std::vector<double> parameters)
      : curve_(edge), parameters_(std::move(parameters)) {}

  Standard_Integer PointsNb() const override { return static_cast<Standard_Integer>(parameters_.size()); }

  Standard_Boolean Value(const Standard_Integer index, gp_Pnt& point, Standard_Real& parameter) const override {
    parameter = parameters_[static_cast<std::size_t>(index - 1)];
    point = curve_.Value(parameter);
    return Standard_True;
  }

 private:
  BRepAdaptor_Curve curve_;
  std::vector<double> parameters_;
};

/// The normals of a face along one of its edges.
class NormalsAlong {
 public:
  NormalsAlong(const TopoDS_Edge& edge, const TopoDS_Face& face) : surface_(face, /*Restriction=*/false) {
    double first = 0, last = 0;
    curve_ = BRep_Tool::CurveOnSurface(edge, face, first, last);
  }

  /// Whether the face turns too much between two points that are so far apart. An outline that crosses the edge there
  /// leaves it by the height of an arc that turns as the face does. Not where the face has no normal.
  [[nodiscard]] bool turn(double from, double to, double apart, const Fine& fine) const {
    const auto one = normal(from), other = normal(to);
    if (!one || !other || !(apart > fine.deflection)) return false;
    const double angle = one->Angle(*other);
    return angle > fine.angle || angle * apart / 8 > fine.deflection;
  }

  [[nodiscard]] bool may_turn() const { return !curve_.IsNull() && surface_.GetType() > GeomAbs_Torus; }

 private:
  [[nodiscard]] std::optional<gp_Vec> normal(double parameter) const {
    const gp_Pnt2d place = curve_->Value(parameter);
    gp_Pnt point;
    gp_Vec along_u, along_v;
    surface_.D1(place.X(), place.Y(), point, along_u, along_v);
    const gp_Vec across = along_u.Crossed(along_v);
    if (!(across.Magnitude() > 1e-9 * (along_u.SquareMagnitude() + along_v.SquareMagnitude()))) return std::nullopt;
    return across;
  }

  BRepAdaptor_Surface surface_;
  Handle(Geom2d_Curve) curve_;
};

/// Finds the parameters of the points of an edge.
class Division {
 public:
  Division(const TopoDS_Edge& edge, const std::vector<NormalsAlong>& faces, const Fine& fine)
      : curve_(edge), faces_(faces), fine_(fine) {}

  /// Appends those after `from`, up to `to`.
  void divide(double from, double to, std::vector<double>& parameters, int halvings = 0) const {
    const double apart = curve_.Value(from).Distance(curve_.Value(to)), middle = (from + to) / 2;
    const bool turns = std::any_of(faces_.begin(), faces_.end(),
                                   [&](const NormalsAlong& face) { return face.turn(from, to, apart, fine_); });
    if (!turns || halvings == most_halvings) return parameters.push_back(to);
    divide(from, middle, parameters, halvings + 1);
    divide(middle, to, parameters, halvings + 1);
  }

 private:
  BRepAdaptor_Curve curve_;
  const std::vector<NormalsAlong>& faces_;
  Fine fine_;
};

void divide(const IMeshData::IEdgeHandle& edge, const Fine& fine) {
  IMeshData_Curve& curve = *edge->GetCurve();
  if (edge->IsFree() || edge->GetDegenerated() || curve.ParametersNb() < 2) return;
  std::vector<NormalsAlong> faces;
  for (int i = 0; i < edge->PCurvesNb(); ++i) {
    NormalsAlong face(edge->GetEdge(), edge->GetPCurve(i)->GetFace()->GetFace());
    if (face.may_turn()) faces.push_back(std::move(face));
  }
  if (faces.empty()) return;
  std::vector<double> parameters{curve.GetParameter(0)};
  const Division division(edge->GetEdge(), faces, fine);
  for (int i = 1; i < curve.ParametersNb(); ++i)
    division.divide(curve.GetParameter(i - 1), curve.GetParameter(i), parameters);
  if (static_cast<int>(parameters.size()) == curve.ParametersNb()) return;
  edge->Clear(/*isKeepEndPoints=*/true);
  BRepMesh_EdgeDiscret::Tessellate3d(edge, new AtParameters(edge->GetEdge(), std::move(parameters)), false);
  BRepMesh_EdgeDiscret::Tessellate2d(edge, false);
}

}  // namespace

Standard_Boolean TurningEdges::performInternal(const Handle(IMeshData_Model) & model,
                                               const IMeshTools_Parameters& parameters,
                                               const Message_ProgressRange& range) {
  if (!BRepMesh_EdgeDiscret::performInternal(model, parameters, range)) return Standard_False;
  const Fine fine{parameters.Deflection / told_for_wanted, parameters.Angle};
  OSD_Parallel::For(
      0, model->EdgesNb(), [&](int i) { divide(model->GetEdge(i), fine); }, !parameters.InParallel);
  return Standard_True;
}

}  // namespace occt
