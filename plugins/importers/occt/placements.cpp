// SPDX-License-Identifier: Apache-2.0
#include "placements.hpp"

#include <gp.hxx>

namespace occt {

std::optional<gp_XYZ> triple(const Handle(StepGeom_CartesianPoint) & point) {
  if (point.IsNull() || point->NbCoordinates() != 3) return std::nullopt;
  return gp_XYZ(point->CoordinatesValue(1), point->CoordinatesValue(2), point->CoordinatesValue(3));
}

std::optional<gp_XYZ> triple(const Handle(StepGeom_Direction) & direction) {
  if (direction.IsNull() || direction->NbDirectionRatios() != 3) return std::nullopt;
  const gp_XYZ ratios(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                      direction->DirectionRatiosValue(3));
  return ratios.Modulus() > gp::Resolution() ? std::optional(ratios) : std::nullopt;
}

std::optional<gp_Ax2> axes_of(const Handle(StepGeom_Axis2Placement3d) & placement) {
  if (placement.IsNull()) return std::nullopt;
  const auto origin = triple(placement->Location());
  const auto z = placement->HasAxis() ? triple(placement->Axis()) : gp_XYZ(0, 0, 1);
  if (!origin || !z) return std::nullopt;
  const auto x = placement->HasRefDirection() ? triple(placement->RefDirection()) : std::nullopt;
  if (x && gp_Dir(*x).IsParallel(gp_Dir(*z), gp::Resolution())) return std::nullopt;
  return x ? gp_Ax2(gp_Pnt(*origin), gp_Dir(*z), gp_Dir(*x)) : gp_Ax2(gp_Pnt(*origin), gp_Dir(*z));
}

}  // namespace occt
