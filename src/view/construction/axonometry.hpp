// SPDX-License-Identifier: Apache-2.0
// Constructions of parallel projections, as figures of constant size beside the view: the axes with their ratios and
// angles, the ellipses of circles on the faces of a cube, and the trace triangle. ISO 5456-3.
//
// With the projector p, the unit vector along an axis a is drawn as (a.u, a.v) - (a.n) (p.u, p.v)/(p.n), times the
// factor of the projection: its length is the ratio of the axis.
#pragma once

#include <span>

#include "construction/figure.hpp"
#include "construction/picture_plane.hpp"
#include "construction/request.hpp"

namespace epura::construction {

/// `factor`: length on the page of a unit in the plane, projection::Projection::scale. Throws Error{input} for a trace
/// triangle that does not exist, unless it is optional.
Figure axonometry_figure(const PicturePlane& plane, double factor, std::span<const Request> requests);

}  // namespace epura::construction
