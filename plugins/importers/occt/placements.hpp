// SPDX-License-Identifier: Apache-2.0
// Points, directions and axes of STEP, in the unit of the file; nothing if they are damaged.
#pragma once

#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Direction.hxx>
#include <gp_Ax2.hxx>
#include <gp_XYZ.hxx>
#include <optional>

namespace occt {

std::optional<gp_XYZ> triple(const Handle(StepGeom_CartesianPoint) & point);
std::optional<gp_XYZ> triple(const Handle(StepGeom_Direction) & direction);

/// What a placement leaves out is along the axes of space, as far as possible (ISO 10303-42).
std::optional<gp_Ax2> axes_of(const Handle(StepGeom_Axis2Placement3d) & placement);

}  // namespace occt
