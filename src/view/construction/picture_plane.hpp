// SPDX-License-Identifier: Apache-2.0
// The plane of a projection on paper. Everything here follows from the plane and the projectors alone, never from the
// name of a projection, so that plugins of other authors are constructed, too.
#pragma once

#include <array>
#include <optional>

#include "base/vec.hpp"
#include "projection/projection.hpp"

namespace epura::construction {

struct PicturePlane {
  bool central = false;
  Vec3 u{0.0}, v{0.0}, n{0.0};  ///< right, up and towards the viewer: orthonormal
  Vec3 projector{0.0};          ///< central: the centre; parallel: a direction towards the viewer
  Vec3 foot{0.0};     ///< the point of the plane at `origin`; central: the foot of the perpendicular from the centre
  Vec2 origin{0, 0};  ///< on paper; central: the principal point
  double scale = 1;   ///< mm on paper of a unit in the plane
  double eye = 0;     ///< central: distance of the centre from the plane, mm on paper
  Mat4 world_to_page{1.0};  ///< (row0/row3, row1/row3), mm
};

/// `scale`: mm of paper per unit of the world, as of drawing::ViewDrawing.
PicturePlane picture_plane(const projection::Projection& projection, const Mat4& world_to_page, double scale);

/// The image of a point, or nothing behind the viewer.
std::optional<Vec2> image_of(const PicturePlane& plane, const Vec3& point);

/// The image of the point at infinity of a direction: M_per (direction, 0). Nothing if it is parallel to the plane
/// (cosine to its normal at most 1e-12).
std::optional<Vec2> vanishing_point(const PicturePlane& plane, const Vec3& direction);

/// A line in the picture plane: the point of it that is nearest to the plane's origin, and its direction; length 1. To
/// the left of the direction is the side to which the normal of the space plane points.
struct PictureLine {
  Vec2 foot, along;

  [[nodiscard]] Vec2 across() const { return {-along.y, along.x}; }
};

/// The image of the line at infinity of the planes with a normal; nothing if they are parallel to the picture.
std::optional<PictureLine> vanishing_line(const PicturePlane& plane, const Vec3& normal);

/// The line in which the plane through a point with a normal cuts the picture; nothing if they are parallel.
std::optional<PictureLine> trace_of_plane(const PicturePlane& plane, const Vec3& point, const Vec3& normal);

/// The point in which a line of the world pierces the picture plane, on paper; nothing if it is parallel to it.
std::optional<Vec2> trace_of_line(const PicturePlane& plane, const Vec3& from, const Vec3& to);

/// Parallel projectors: the images of unit vectors along the world axes, in units of the sheet's scale.
std::array<Vec2, 3> axis_images(const PicturePlane& plane, double length_in_plane);

}  // namespace epura::construction
