// SPDX-License-Identifier: Apache-2.0
// Constructions of central projections: horizon, vanishing and measuring points, station point, ground line, cone of
// vision. z is up.
//
// With the principal point PP as origin and the eye at distance e: the direction d vanishes at -e (d.u, d.v)/(d.n), and
// planes with normal m on the line (m.u, m.v) . p = e (m.n). The station point SP is the eye folded about the horizon
// into the picture. The measuring point M of a horizontal direction lies on the horizon as far from its vanishing point
// as SP does: lines through M cut off true lengths (times the scale) on lines of the picture parallel to the horizon.
#pragma once

#include <span>

#include "construction/figure.hpp"
#include "construction/picture_plane.hpp"
#include "construction/request.hpp"

namespace epura::construction {

/// Throws Error{input} for what lies at infinity, unless it is optional.
Figure perspective_figure(const PicturePlane& plane, std::span<const Request> requests, const Surroundings& around);

/// The eye folded about a vanishing line into the picture, on the side away from the planes' normal.
Vec2 folded_eye(const PicturePlane& plane, const PictureLine& line);

/// The measuring point of a vanishing point on the line.
Vec2 measuring_point(const PicturePlane& plane, const PictureLine& line, const Vec2& vanishing_point);

}  // namespace epura::construction
