// SPDX-License-Identifier: Apache-2.0
#include "projection/matrices.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"

namespace epura::projection {

namespace {

// Cosine between axis and normal below which an axis is parallel to the plane. Sines of right angles leave 1e-16; a
// vanishing point at a distance of 1e12 eye distances is on no page.
constexpr double parallel_cosine = 1e-12;

/// (3.48), which (3.58) uses, too: S(s) T(-dr, -ds, 0) SH(shu, shv) T(0, 0, -B).
Mat4 normalisation(const ViewVolume& volume, double dr, double ds, const Vec3& s) {
  const Vec2 middle = (volume.window.min + volume.window.max) / 2.0;
  const Vec3 dop = volume.prp - Vec3(middle, volume.plane);  // (3.41)
  const double shu = -dop.x / dop.z, shv = -dop.y / dop.z;   // (3.40)
  const double b = volume.back;
  return rows({s.x, 0, s.x * shu, -s.x * (b * shu + dr)},  //
              {0, s.y, s.y * shv, -s.y * (b * shv + ds)},  //
              {0, 0, s.z, -s.z * b},                       //
              {0, 0, 0, 1});
}

/// World -> (u, v, n) relative to the plane's point.
Mat4 plane_coordinates(const Projection& p) {
  const auto row = [&p](const Vec3& axis) { return Vec4(axis, -glm::dot(axis, p.point)); };
  return rows(row(p.u), row(p.v), row(p.n), {0, 0, 0, 1});
}

/// Rows of a matrix, without the last number of each.
struct Rows {
  Vec3 x, y, depth, w;
};

// With A = (x; y) / w, A d = 0: where A has the singular values s1 >= s2 with right singular vectors a1, a2, it is a
// similarity of factor s2 on the plane along (s2 / s1) a1 + sqrt(1 - (s2 / s1)^2) d and a2.
Projection parallel_of(const Rows& rows, const Vec4& last) {
  const Vec3 a0 = rows.x / last.w, a1 = rows.y / last.w;
  Projection p;
  p.projector = glm::cross(a0, a1);
  const double xx = glm::dot(a0, a0), xy = glm::dot(a0, a1), yy = glm::dot(a1, a1);
  const double area = glm::length(p.projector);  // s1 s2
  if (!(area > parallel_sine * (xx + yy)))
    refuse_input("matrix", "makes a flat picture", "its first two rows must differ");
  p.projector /= area;
  const double towards = glm::dot(rows.depth, p.projector) / last.w;
  if (towards == 0) refuse_input("matrix", "does not tell on which side the viewer is", "let row 2 grow towards him");
  if (towards < 0)
    refuse_input("matrix", "mirrors the picture",
                 "change the sign of row 0, or of row 2 if it falls towards the viewer");
  // The angle of the first singular vector on the page.
  const double turn = 0.5 * portable_atan2(2 * xy, xx - yy), c = portable_cos(turn), s = portable_sin(turn);
  const double large = std::sqrt(c * c * xx + 2 * c * s * xy + s * s * yy);
  p.scale = area / large;
  const double part = std::min(p.scale / large, 1.0);
  const Vec3 along = part * (c * a0 + s * a1) / large + std::sqrt((1 - part) * (1 + part)) * p.projector;
  const Vec3 across = (c * a1 - s * a0) / p.scale;
  p.u = glm::normalize(c * along - s * across);
  p.n = glm::normalize(glm::cross(along, across));
  p.v = glm::cross(p.n, p.u);
  // Of the points that are seen in the origin, the one nearest to that of the world.
  const Vec2 shift(last.x / last.w, last.y / last.w);
  p.point = -((yy * shift.x - xy * shift.y) * a0 + (xx * shift.y - xy * shift.x) * a1) / (area * area);
  return p;
}

// Row 3 is the distance from the centre along the normal, times some factor; rows 0 and 1 less their parts along it
// are u and v, times the same factor and the distance of the plane.
Projection central_of(const Rows& rows, const Vec4& last) {
  Projection p;
  p.central = true;
  const double factor = glm::length(rows.w);
  p.n = -rows.w / factor;
  const Vec2 middle = -Vec2(glm::dot(rows.x, p.n), glm::dot(rows.y, p.n)) / factor;  // the foot of the centre
  const Vec3 across = rows.x - middle.x * rows.w, upwards = rows.y - middle.y * rows.w;
  const double width = glm::length(across), height = glm::length(upwards);
  if (!(width > 0 && height > 0) || glm::length(glm::cross(across, upwards)) < parallel_sine * width * height)
    refuse_input("matrix", "makes a flat picture", "its first two rows must differ, and both from row 3");
  if (std::abs(width - height) > parallel_sine * width ||
      std::abs(glm::dot(across, upwards)) > parallel_sine * width * height)
    refuse_input("matrix", "stretches the picture", "give both axes of the page the same unit, at right angles");
  if (glm::dot(glm::cross(across, upwards), p.n) < 0)
    refuse_input("matrix", "mirrors the picture",
                 "change the sign of row 0, or of row 3 if it is negative in front of the viewer");
  p.u = glm::normalize(across);
  p.v = glm::cross(p.n, p.u);
  const Mat3 linear = glm::transpose(Mat3(rows.x, rows.y, rows.w));
  p.projector = -glm::inverse(linear) * Vec3(last.x, last.y, last.w);
  p.point = p.projector - width / factor * p.n - middle.x * p.u - middle.y * p.v;
  return p;
}

}  // namespace

Projection projection_of_matrix(const Mat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row])) refuse_input("matrix", "has a number that is not finite", "");
  const Rows rows{Vec3(glm::row(matrix, 0)), Vec3(glm::row(matrix, 1)), Vec3(glm::row(matrix, 2)),
                  Vec3(glm::row(matrix, 3))};
  const Vec4& last = matrix[3];
  if (rows.w != Vec3(0)) return central_of(rows, last);
  if (last.w == 0) refuse_input("matrix", "has zeros in row 3", "let it end with 1");
  return parallel_of(rows, last);
}

Mat4 m_per(const Vec3& point, const Vec3& normal, const Vec3& centre) {
  const Vec3& n = normal;
  const double a = centre.x, b = centre.y, c = centre.z;
  const double d0 = glm::dot(point, n), d1 = glm::dot(centre, n);
  const double d = glm::dot(point - centre, n);          // (3.15): keeps its digits far from the origin, unlike d0 - d1
  return rows({d + a * n.x, a * n.y, a * n.z, -a * d0},  //
              {b * n.x, d + b * n.y, b * n.z, -b * d0},  //
              {c * n.x, c * n.y, d + c * n.z, -c * d0},  //
              {n.x, n.y, n.z, -d1});
}

Mat4 m_par(const Vec3& point, const Vec3& normal, const Vec3& direction) {
  const Vec3& n = normal;
  const double a = direction.x, b = direction.y, c = direction.z;
  const double d0 = glm::dot(point, n), d1 = glm::dot(direction, n);
  return rows({d1 - a * n.x, -a * n.y, -a * n.z, a * d0},  //
              {-b * n.x, d1 - b * n.y, -b * n.z, b * d0},  //
              {-c * n.x, -c * n.y, d1 - c * n.z, c * d0},  //
              {0, 0, 0, d1});
}

Mat4 view_orientation(const Vec3& vrp, const Vec3& vpn, const Vec3& vup) {
  Projection frame;
  frame.point = vrp;
  frame.u = glm::normalize(glm::cross(vup, vpn));
  frame.n = glm::normalize(vpn);
  frame.v = glm::cross(frame.n, frame.u);
  return plane_coordinates(frame);
}

Mat4 n_par(const ViewVolume& volume) {
  const Vec2 size = volume.window.max - volume.window.min;
  const Vec2 middle = (volume.window.min + volume.window.max) / 2.0;
  const Vec3 dop = volume.prp - Vec3(middle, volume.plane);
  const double above_back = volume.plane - volume.back;
  const double dr = volume.window.min.x - above_back * dop.x / dop.z;  // (3.42)
  const double ds = volume.window.min.y - above_back * dop.y / dop.z;  // (3.43)
  return normalisation(volume, dr, ds, 1.0 / Vec3(size, volume.front - volume.back));
}

Mat4 n_per(const ViewVolume& volume) {
  const Vec2 size = volume.window.max - volume.window.min;
  const double height = volume.prp.z - volume.back;             // (3.54)
  const double grown = height / (volume.prp.z - volume.plane);  // from the view plane to the back plane
  const double above_back = volume.plane - volume.back, to_plane = volume.plane - volume.prp.z;
  const double dr = (-height * volume.window.min.x + volume.prp.x * above_back) / to_plane;  // (3.50)
  const double ds = (-height * volume.window.min.y + volume.prp.y * above_back) / to_plane;  // (3.51)
  return normalisation(volume, dr, ds, 1.0 / Vec3(size * grown, height));
}

Mat4 m_per_npc(const ViewVolume& volume) {
  const double dt = (volume.plane - volume.back) / (volume.prp.z - volume.back);  // (3.61)
  return rows({dt - 1, 0, 0.5, -dt / 2},                                          //
              {0, dt - 1, 0.5, -dt / 2},                                          //
              {0, 0, dt, -dt},                                                    //
              {0, 0, 1, -1});
}

Window npc_window(const ViewVolume& volume, bool central) {
  if (!central) return {{0, 0}, {1, 1}};
  const double dt = (volume.plane - volume.back) / (volume.prp.z - volume.back);
  return {{dt / 2, dt / 2}, {1 - dt / 2, 1 - dt / 2}};
}

Mat4 window_to_viewport(const Window& window, const Window& viewport) {
  const Vec2 s = (viewport.max - viewport.min) / (window.max - window.min);
  const Vec2 t = viewport.min - window.min * s;
  return rows({s.x, 0, 0, t.x}, {0, s.y, 0, t.y}, {0, 0, 1, 0}, {0, 0, 0, 1});
}

Mat4 plane_matrix(const Projection& p) {
  return p.central ? m_per(p.point, p.n, p.projector) : m_par(p.point, p.n, p.projector);
}

Mat4 view_matrix(const Projection& p) {
  const Mat4 coordinates = plane_coordinates(p);
  const Vec4 n_row = glm::row(coordinates, 2);
  if (!p.central) {
    const Mat4 flat = coordinates * plane_matrix(p) / glm::dot(p.projector, p.n);
    return rows(glm::row(flat, 0), glm::row(flat, 1), n_row, {0, 0, 0, 1});
  }
  // In M_per, w' = n.(x - centre) is negative in front of the viewer.
  const Mat4 flat = -(coordinates * plane_matrix(p));
  const double eye = glm::dot(p.projector - p.point, p.n);
  return rows(glm::row(flat, 0), glm::row(flat, 1), eye * n_row, glm::row(flat, 3));
}

std::array<std::optional<Vec2>, 3> vanishing_points(const Projection& p) {
  std::array<std::optional<Vec2>, 3> points;
  if (!p.central) return points;
  const Mat4 flat = plane_coordinates(p) * plane_matrix(p);
  for (int i = 0; i < 3; ++i) {
    Vec4 axis(0);
    axis[i] = 1;
    const Vec4 image = flat * axis;
    if (std::abs(image.w) > parallel_cosine) points[static_cast<std::size_t>(i)] = Vec2(image) / image.w;
  }
  return points;
}

}  // namespace epura::projection
