// SPDX-License-Identifier: Apache-2.0
#include "surface.hpp"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BoundedSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TopLoc_Location.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>

#include "canonical.hpp"

namespace occt {

namespace {

constexpr double same_length = 1e-7;  // mm, Open CASCADE's own precision
constexpr double same_angle = 1e-9;

using Surface = Handle(Geom_Surface);

/// The same surface without limits of parameters, and without an offset that can be resolved.
Surface resolved(Surface surface) {
  for (;;) {
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trimmed.IsNull()) {
      surface = trimmed->BasisSurface();
      continue;
    }
    const auto offset = Handle(Geom_OffsetSurface)::DownCast(surface);
    if (offset.IsNull() || offset->Surface().IsNull() || offset->Surface() == surface) return surface;
    surface = offset->Surface();
  }
}

/// A line rotated about an axis in its plane.
Surface turned_line(const gp_Lin& line, const gp_Ax1& axis) {
  const gp_Lin centre(axis);
  const gp_Vec out(axis.Location(), line.Location());
  const double along = out.Dot(axis.Direction());
  const gp_Vec radial = out - along * gp_Vec(axis.Direction());
  if (line.Direction().IsParallel(axis.Direction(), same_angle)) {
    const double radius = centre.Distance(line.Location());
    if (radius < same_length) return {};
    return new Geom_CylindricalSurface(gp_Ax3(axis.Location(), axis.Direction()), radius);
  }
  const gp_Pnt foot = axis.Location().Translated(along * gp_Vec(axis.Direction()));
  if (line.Direction().IsNormal(axis.Direction(), same_angle)) return new Geom_Plane(gp_Ax3(foot, axis.Direction()));
  // Skew lines sweep hyperboloids.
  const gp_Vec across = gp_Vec(line.Direction()).Crossed(gp_Vec(axis.Direction()));
  if (std::abs(radial.Dot(across)) > same_length * across.Magnitude()) return {};
  const double rise = line.Direction().Dot(axis.Direction());
  const gp_Vec sideways = gp_Vec(line.Direction()) - rise * gp_Vec(axis.Direction());
  const double radius = radial.Magnitude();
  const gp_Dir outward = radius > same_length ? gp_Dir(radial) : gp_Dir(sideways);
  const double half_angle = std::atan(sideways.Dot(gp_Vec(outward)) / rise);
  return new Geom_ConicalSurface(gp_Ax3(foot, axis.Direction(), outward), half_angle, radius);
}

/// A circle rotated about an axis in its plane.
Surface turned_circle(const gp_Circ& circle, const gp_Ax1& axis) {
  const gp_Lin centre(axis);
  if (!circle.Axis().Direction().IsNormal(axis.Direction(), same_angle)) return {};
  const gp_Vec out(axis.Location(), circle.Location());
  if (std::abs(out.Dot(gp_Vec(circle.Axis().Direction()))) > same_length) return {};
  const double distance = centre.Distance(circle.Location());
  if (distance < same_length)
    return new Geom_SphericalSurface(gp_Ax3(circle.Location(), axis.Direction()), circle.Radius());
  const gp_Pnt foot = axis.Location().Translated(out.Dot(gp_Vec(axis.Direction())) * gp_Vec(axis.Direction()));
  return new Geom_ToroidalSurface(gp_Ax3(foot, axis.Direction()), distance, circle.Radius());
}

Surface turned(const Geom_SurfaceOfRevolution& surface) {
  const GeomAdaptor_Curve curve(surface.BasisCurve());
  const gp_Ax1 axis = surface.Axis();
  if (curve.GetType() == GeomAbs_Line) return turned_line(curve.Line(), axis);
  return curve.GetType() == GeomAbs_Circle ? turned_circle(curve.Circle(), axis) : Surface();
}

Surface extruded(const Geom_SurfaceOfLinearExtrusion& surface) {
  const GeomAdaptor_Curve curve(surface.BasisCurve());
  const gp_Dir along = surface.Direction();
  if (curve.GetType() == GeomAbs_Line && !curve.Line().Direction().IsParallel(along, same_angle))
    return new Geom_Plane(curve.Line().Location(), curve.Line().Direction().Crossed(along));
  if (curve.GetType() == GeomAbs_Circle && curve.Circle().Axis().Direction().IsParallel(along, same_angle))
    return new Geom_CylindricalSurface(gp_Ax3(curve.Circle().Location(), along), curve.Circle().Radius());
  return {};
}

/// The simple surface with which this one coincides, or the surface itself.
Surface simplest(const Surface& surface, const TopoDS_Face& face) {
  Surface found;
  if (const auto swept = Handle(Geom_SurfaceOfRevolution)::DownCast(surface); !swept.IsNull()) found = turned(*swept);
  if (const auto swept = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface); !swept.IsNull())
    found = extruded(*swept);
  if (!found.IsNull()) return found;
  if (surface->IsKind(STANDARD_TYPE(Geom_BoundedSurface)) || surface->IsKind(STANDARD_TYPE(Geom_SweptSurface)) ||
      surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface))) {
    Range range{};
    BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
    found = canonical(*surface, range);
  }
  return found.IsNull() ? surface : found;
}

void set(double (&to)[3], const gp_XYZ& from) {
  for (int i = 0; i < 3; ++i) to[i] = from.Coord(i + 1);
}

epura_face described(std::uint32_t kind, const gp_Ax3& position, double radius) {
  epura_face face{};
  face.kind = kind;
  face.radius = radius;
  set(face.origin, position.Location().XYZ());
  set(face.axis, position.Direction().XYZ());
  return face;
}

}  // namespace

epura_face surface_of(const TopoDS_Face& face) {
  epura_face free_form{};
  free_form.kind = EPURA_FREE_FORM;
  TopLoc_Location location;
  const Surface given = BRep_Tool::Surface(face, location);
  if (given.IsNull()) return free_form;
  const gp_Trsf& move = location.Transformation();
  const Surface surface = simplest(resolved(given), face);
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) {
    epura_face described_plane = described(EPURA_PLANE, plane->Position().Transformed(move), 0);
    // A mirror image also mirrors the outward normal: the handedness of the plane before the transform counts.
    if ((face.Orientation() == TopAbs_REVERSED) == plane->Position().Direct())
      for (double& coordinate : described_plane.axis) coordinate = -coordinate;
    return described_plane;
  }
  if (const auto round = Handle(Geom_CylindricalSurface)::DownCast(surface); !round.IsNull()) {
    const gp_Cylinder cylinder = round->Cylinder().Transformed(move);
    return described(EPURA_CYLINDER, cylinder.Position(), cylinder.Radius());
  }
  if (const auto round = Handle(Geom_ConicalSurface)::DownCast(surface); !round.IsNull()) {
    const gp_Cone cone = round->Cone().Transformed(move);
    epura_face described_cone = described(EPURA_CONE, cone.Position(), cone.RefRadius());
    described_cone.slope = std::tan(cone.SemiAngle());
    return described_cone;
  }
  if (const auto round = Handle(Geom_SphericalSurface)::DownCast(surface); !round.IsNull()) {
    const gp_Sphere sphere = round->Sphere().Transformed(move);
    return described(EPURA_SPHERE, sphere.Position(), sphere.Radius());
  }
  if (const auto round = Handle(Geom_ToroidalSurface)::DownCast(surface); !round.IsNull()) {
    const gp_Torus torus = round->Torus().Transformed(move);
    epura_face described_torus = described(EPURA_TORUS, torus.Position(), torus.MajorRadius());
    described_torus.minor = torus.MinorRadius();
    return described_torus;
  }
  return free_form;
}

}  // namespace occt
