// SPDX-License-Identifier: Apache-2.0
// The matrices of projections and of the viewing model, as functions of their parameters.
// Numbers in brackets are equations of seed document 003 (after the PHIGS viewing model). Column vectors: p' = M p.
#pragma once

#include "base/vec.hpp"
#include "projection/projection.hpp"

namespace epura::projection {

/// M_per (3.10, 3.19): central projection from `centre` onto the plane through `point` with unit normal `normal`.
Mat4 m_per(const Vec3& point, const Vec3& normal, const Vec3& centre);

/// M_par (3.20, 3.29): parallel projection along `direction` onto the plane through `point` with unit normal `normal`.
Mat4 m_par(const Vec3& point, const Vec3& normal, const Vec3& direction);

/// View orientation matrix VOM = R T (3.36): world -> view reference coordinates (u, v, n).
Mat4 view_orientation(const Vec3& vrp, const Vec3& vpn, const Vec3& vup);

/// The viewing volume of the PHIGS model in view reference coordinates.
struct ViewVolume {
  Window window;       ///< umin, vmin, umax, vmax on the view plane
  double plane;        ///< VPD: n of the view plane
  double front, back;  ///< F, B: n of the clipping planes
  Vec3 prp;            ///< projection reference point
};

Mat4 n_par(const ViewVolume& volume);      ///< (3.48): view volume -> unit cube
Mat4 n_per(const ViewVolume& volume);      ///< (3.58): view volume -> unit pyramid with apex (1/2, 1/2, 1)
Mat4 m_per_npc(const ViewVolume& volume);  ///< (3.60): central projection in normalised coordinates
Window npc_window(const ViewVolume& volume, bool central);  ///< (3.67)-(3.72)

/// Window -> viewport (3.63), on homogeneous points: x and y are mapped, z and w stay. Either may be mirrored.
Mat4 window_to_viewport(const Window& window, const Window& viewport);

/// The projection as one matrix onto its plane, in world coordinates: M_per or M_par.
Mat4 plane_matrix(const Projection& projection);

/// World -> (u, v) of the projection plane with depth, so that straight lines stay straight and planes flat: the plane
/// matrix in coordinates of the plane, with another third row. (row0/row3, row1/row3) = (u, v); row3 > 0 in front of
/// the viewer; row2/row3 is depth, 0 on the plane and growing towards the viewer. Let N be the coordinate along n:
///   parallel  depth = N
///   central   depth = e N / w, where w = e - N is the distance from the viewer along n, and e that of the plane. This
///             tends to N as the viewer recedes. It is the matrix P_d (6.3) of seed 002, and e^2/w - e, which is z_s of
///             seed 000 except for scale and offset.
Mat4 view_matrix(const Projection& projection);

/// The projection whose picture a matrix makes: the matrix takes a point, as a column vector, to (row0/row3,
/// row1/row3), lengths on the page as in `scale`. Parallel if the first three numbers of row 3 are 0; then row 2 grows
/// towards the viewer. Any such matrix is a parallel projection onto some plane (Pohlke's theorem); of the two planes
/// on which it is a similarity, either gives the same picture. Otherwise, row 3 is positive in front of the viewer, and
/// the plane is parallel to that where it is 0. Throws Error{input} for numbers that are not finite, for a picture that
/// is flat, mirrored or, if central, stretched.
Projection projection_of_matrix(const Mat4& matrix);

/// Returns where lines along the three world axes meet on the plane, in (u, v): M (axis, 0). Nothing for an axis
/// parallel to the plane (cosine to the normal at most 1e-12), or for parallel projectors.
std::array<std::optional<Vec2>, 3> vanishing_points(const Projection& projection);

}  // namespace epura::projection
