// SPDX-License-Identifier: Apache-2.0
// The B-splines along which edges of Open CASCADE run, for epura_sink::spline (epura/importer_abi.h), in one header.
#pragma once

#include <epura/importer_abi.h>

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <cstdint>
#include <gp_Pnt.hxx>
#include <utility>
#include <vector>

namespace epura {

/// The spline of an edge, in the coordinates of its points.
class OpenCascadeSpline {
 public:
  /// `parameters`: of the points of the edge, as Poly_PolygonOnTriangulation has them; empty: not known.
  OpenCascadeSpline(const TopoDS_Edge& edge, std::vector<double> parameters) : parameters_(std::move(parameters)) {
    if (parameters_.size() < 2) return;
    double first = 0, last = 0;
    TopLoc_Location location;
    Handle(Geom_BSplineCurve) curve = spline_of(BRep_Tool::Curve(edge, location, first, last));
    if (curve.IsNull() || curve->Degree() < 2) return;  // the points of a polyline tell it
    if (curve->IsPeriodic()) {
      curve = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
      curve->SetNotPeriodic();
    }
    // An edge across the end of a closed curve.
    if (parameters_.front() < curve->FirstParameter() || parameters_.back() > curve->LastParameter()) return;
    take(*curve, location.Transformation());
  }

  /// Valid as long as this object; false: the edge has none.
  [[nodiscard]] bool told(epura_spline& to) const {
    to = {};
    to.size = sizeof to;
    to.degree = degree_;
    to.pole_count = poles_.size() / 3;
    to.poles = poles_.data();
    to.weights = weights_.empty() ? nullptr : weights_.data();
    to.knots = knots_.data();
    to.parameters = parameters_.data();
    return degree_ > 0;
  }

 private:
  static Handle(Geom_BSplineCurve) spline_of(Handle(Geom_Curve) curve) {
    while (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom_TrimmedCurve)))
      curve = Handle(Geom_TrimmedCurve)::DownCast(curve)->BasisCurve();
    if (!curve.IsNull() && curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)))
      return GeomConvert::CurveToBSplineCurve(curve);
    return Handle(Geom_BSplineCurve)::DownCast(curve);
  }

  void take(const Geom_BSplineCurve& curve, const gp_Trsf& place) {
    degree_ = static_cast<std::uint32_t>(curve.Degree());
    for (int i = 1; i <= curve.NbPoles(); ++i) {
      const gp_Pnt pole = curve.Pole(i).Transformed(place);
      poles_.insert(poles_.end(), {pole.X(), pole.Y(), pole.Z()});
      if (curve.IsRational()) weights_.push_back(curve.Weight(i));
    }
    for (int i = 1; i <= curve.NbKnots(); ++i)
      knots_.insert(knots_.end(), static_cast<std::size_t>(curve.Multiplicity(i)), curve.Knot(i));
  }

  std::uint32_t degree_ = 0;
  std::vector<double> poles_, weights_, knots_, parameters_;
};

}  // namespace epura
