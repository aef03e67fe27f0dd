// SPDX-License-Identifier: Apache-2.0
// The matrices against their derivations, written out here step by step (equation numbers of seed 003).
#include "projection/matrices.hpp"

#include "support.hpp"

namespace epura::test::matrices_test {
namespace {

const Vec3 r0{2, -1, 3}, n{2.0 / 7, 3.0 / 7, 6.0 / 7}, c{5, 4, 9}, x{0.3, -2.5, 1.75};

Mat4 translation(const Vec3& t) { return rows({1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1}); }
Mat4 scaling(const Vec3& s) { return rows({s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}); }
Mat4 shear(double u, double v) { return rows({1, 0, u, 0}, {0, 1, v, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}); }
Vec3 cartesian(const Vec4& h) { return Vec3(h) / h.w; }

TEST(m_per, is_the_projection_from_the_origin_moved_to_the_centre) {
  const double d = glm::dot(r0 - c, n);
  const Mat4 from_origin = rows({d, 0, 0, 0}, {0, d, 0, 0}, {0, 0, d, 0}, {n.x, n.y, n.z, 0});      // (3.14)
  expect_near(projection::m_per(r0, n, c), translation(c) * from_origin * translation(-c), 1e-12);  // (3.17)
}

TEST(m_per, with_the_centre_at_the_origin_is_3_1) {
  const double d0 = glm::dot(r0, n);
  expect_near(projection::m_per(r0, n, Vec3(0)), rows({d0, 0, 0, 0}, {0, d0, 0, 0}, {0, 0, d0, 0}, {n.x, n.y, n.z, 0}),
              1e-12);
}

TEST(m_per, sends_a_point_along_its_projector_into_the_plane) {
  const Vec3 p = cartesian(projection::m_per(r0, n, c) * Vec4(x, 1));
  EXPECT_NEAR(glm::dot(p - r0, n), 0, 1e-12);
  EXPECT_NEAR(glm::length(glm::cross(p - c, x - c)), 0, 1e-11);
}

TEST(m_par, sends_a_point_along_the_direction_into_the_plane) {
  const Vec3 v{1, -2, 5};
  const double t = (glm::dot(r0, n) - glm::dot(x, n)) / glm::dot(v, n);  // (3.27)
  expect_near<3>(cartesian(projection::m_par(r0, n, v) * Vec4(x, 1)), x + t * v, 1e-12);
}

TEST(view_orientation, is_the_camera_of_seed_001_at_minus_3_2_4_turned_45_degrees) {
  const double h = std::sqrt(0.5);
  const Mat4 expected = rows({h, 0, -h, 7 * h}, {0, 1, 0, -2}, {h, 0, h, -h}, {0, 0, 0, 1});
  expect_near(projection::view_orientation({-3, 2, 4}, {h, 0, h}, {0, 1, 0}), expected, 1e-12);
}

projection::ViewVolume a_volume() { return {{{-2, 1}, {4, 5}}, 1, 3, -6, {0.5, -2, 8}}; }

TEST(n_par, is_3_47_multiplied_out_and_maps_the_volume_to_the_unit_cube) {
  const projection::ViewVolume s = a_volume();
  const Vec3 dop = s.prp - Vec3(1, 3, s.plane);
  const double shu = -dop.x / dop.z, shv = -dop.y / dop.z;
  const double dr = -2 + (s.plane - s.back) * shu, ds = 1 + (s.plane - s.back) * shv;
  const Mat4 product = scaling({1.0 / 6, 1.0 / 4, 1.0 / 9}) * translation({-dr, -ds, 0}) * shear(shu, shv) *
                       translation({0, 0, -s.back});
  expect_near(projection::n_par(s), product, 1e-12);
  const auto corner = [&](double u, double v, double at) {
    return cartesian(projection::n_par(s) * Vec4(Vec3(u, v, s.plane) + (at - s.plane) / dop.z * dop, 1));
  };
  expect_near<3>(corner(-2, 1, s.back), {0, 0, 0}, 1e-12);
  expect_near<3>(corner(4, 1, s.front), {1, 0, 1}, 1e-12);
  expect_near<3>(corner(4, 5, s.plane), {1, 1, 7.0 / 9}, 1e-12);
  expect_near<2>(projection::npc_window(s, false).max, {1, 1}, 0);
}

TEST(n_per, is_3_58_multiplied_out) {
  const projection::ViewVolume s = a_volume();
  const Vec3 dop = s.prp - Vec3(1, 3, s.plane);
  const double b = s.back, prp = s.prp.z;
  const double dr = ((b - prp) * -2 + s.prp.x * (s.plane - b)) / (s.plane - prp);
  const double ds = ((b - prp) * 1 + s.prp.y * (s.plane - b)) / (s.plane - prp);
  const double hu = 6 * (prp - b) / (prp - s.plane), hv = 4 * (prp - b) / (prp - s.plane);
  const Mat4 product = scaling({1 / hu, 1 / hv, 1 / (prp - b)}) * translation({-dr, -ds, 0}) *
                       shear(-dop.x / dop.z, -dop.y / dop.z) * translation({0, 0, -b});
  expect_near(projection::n_per(s), product, 1e-12);
}

TEST(n_per, has_its_apex_at_one_half_and_its_window_at_half_dt) {
  const projection::ViewVolume s = a_volume();
  expect_near<3>(cartesian(projection::n_per(s) * Vec4(s.prp, 1)), {0.5, 0.5, 1}, 1e-12);
  const double dt = 7.0 / 14;  // (VPD - B) / (PRPn - B)
  expect_near<3>(cartesian(projection::n_per(s) * Vec4(-2, 1, s.plane, 1)), {dt / 2, dt / 2, dt}, 1e-12);
  expect_near<3>(cartesian(projection::n_per(s) * Vec4(4, 5, s.plane, 1)), {1 - dt / 2, 1 - dt / 2, dt}, 1e-12);
  expect_near<2>(projection::npc_window(s, true).min, {dt / 2, dt / 2}, 1e-15);
  expect_near<2>(projection::npc_window(s, true).max, {1 - dt / 2, 1 - dt / 2}, 1e-15);
}

TEST(m_per_npc, is_m_per_for_the_normal_0_0_1_and_the_apex) {
  const projection::ViewVolume s = a_volume();
  expect_near(projection::m_per_npc(s), projection::m_per({0.1, 0.9, 0.5}, {0, 0, 1}, {0.5, 0.5, 1}), 1e-15);
}

TEST(m_per_npc, and_the_window_give_the_viewport_that_the_projection_on_the_view_plane_gives) {
  const projection::ViewVolume s = a_volume();
  const projection::Window viewport{{0, 297}, {420, 0}};
  const Vec4 p{x, 1};
  const Mat4 through_npc = projection::window_to_viewport(projection::npc_window(s, true), viewport) *
                           projection::m_per_npc(s) * projection::n_per(s);
  const Mat4 direct =
      projection::window_to_viewport(s.window, viewport) * projection::m_per({0, 0, s.plane}, {0, 0, 1}, s.prp);
  expect_near<2>(Vec2(cartesian(through_npc * p)), Vec2(cartesian(direct * p)), 1e-10);
  const Mat4 parallel =
      projection::window_to_viewport(projection::npc_window(s, false), viewport) * projection::n_par(s);
  const Mat4 flat = projection::window_to_viewport(s.window, viewport) *
                    projection::m_par({0, 0, s.plane}, {0, 0, 1}, s.prp - Vec3(1, 3, s.plane));
  expect_near<2>(Vec2(cartesian(parallel * p)), Vec2(cartesian(flat * p)), 1e-10);
}

TEST(window_to_viewport, maps_homogeneous_points_and_mirrors) {
  const Mat4 m = projection::window_to_viewport({{-1, -1}, {1, 1}}, {{0, 400}, {400, 0}});
  expect_near<4>(m * Vec4(-1, -1, 7, 1), {0, 400, 7, 1}, 1e-13);
  expect_near<4>(m * Vec4(1, 3, 7, 2), {600, -200, 7, 2}, 1e-13);
}

projection::Projection a_view(bool central) {
  projection::Projection p;
  p.point = r0;
  p.n = n;
  p.u = glm::normalize(glm::cross(Vec3(0, 0, 1), n));
  p.v = glm::cross(n, p.u);
  p.central = central;
  p.projector = central ? c : Vec3(1, 2, 5);
  return p;
}

class view_matrix_of : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(both, view_matrix_of, testing::Bool());

TEST_P(view_matrix_of, gives_the_plane_matrix_in_coordinates_of_the_plane) {
  const projection::Projection p = a_view(GetParam());
  const Vec4 flat = projection::view_orientation(r0, n, {0, 0, 1}) * (projection::plane_matrix(p) * Vec4(x, 1));
  expect_near<2>(place(p, x), Vec2(flat) / flat.w, 1e-12);
  EXPECT_GT(image(p, x).w, 0);
}

TEST_P(view_matrix_of, has_depth_that_is_zero_on_the_plane_and_affine_along_lines) {
  const projection::Projection p = a_view(GetParam());
  EXPECT_NEAR(depth(p, r0 + 3.0 * p.u - 2.0 * p.v), 0, 1e-12);
  const Vec3 q{-4, 1, -2}, m = 0.3 * x + 0.7 * q;
  const Vec3 a(place(p, x), depth(p, x)), b(place(p, q), depth(p, q)), ab(place(p, m), depth(p, m));
  EXPECT_NEAR(glm::length(glm::cross(b - a, ab - a)), 0, 1e-11);
}

TEST_P(view_matrix_of, has_depth_that_grows_towards_the_viewer) {
  const projection::Projection p = a_view(GetParam());
  const Vec3 to_viewer = p.central ? p.projector - x : p.projector;
  EXPECT_LT(depth(p, x), depth(p, x + 0.1 * to_viewer));
  expect_near<2>(place(p, x + 0.1 * to_viewer), place(p, x), 1e-12);
}

TEST(view_matrix_central, is_negative_behind_the_viewer) { EXPECT_LT(image(a_view(true), c + n).w, 0); }

TEST(view_matrix_central, tends_to_the_parallel_one_as_the_viewer_recedes) {
  projection::Projection far = a_view(true), parallel = a_view(false);
  far.projector = r0 + 1e9 * parallel.projector;
  expect_near<2>(place(far, x), place(parallel, x), 1e-6);
  EXPECT_NEAR(depth(far, x), depth(parallel, x), 1e-6);
}

TEST(vanishing_points, are_the_images_of_the_axes_and_the_limits_of_lines) {
  const projection::Projection p = a_view(true);
  const auto points = projection::vanishing_points(p);
  for (int i = 0; i < 3; ++i) {
    Vec3 axis(0);
    axis[i] = 1;
    ASSERT_TRUE(points[static_cast<std::size_t>(i)]);
    // The projector along the axis meets the plane at C + t axis with n.(C + t axis - R0) = 0.
    const Vec3 hit = c + glm::dot(r0 - c, n) / n[i] * axis;
    expect_near<2>(*points[static_cast<std::size_t>(i)], {glm::dot(hit - r0, p.u), glm::dot(hit - r0, p.v)}, 1e-11);
    expect_near<2>(place(p, x - 1e9 * axis), *points[static_cast<std::size_t>(i)], 1e-6);
  }
}

TEST(vanishing_points, are_missing_for_axes_parallel_to_the_plane_and_for_parallel_projectors) {
  projection::Projection p = a_view(true);
  p.point = Vec3(0);
  // A quarter turn by sine and cosine leaves 6e-17 where zero is meant.
  p.n = {std::cos(std::acos(-1.0) / 2), -1, 0};
  p.u = {1, 0, 0};
  p.v = {0, 0, 1};
  p.projector = {1, -5, 2};
  const auto points = projection::vanishing_points(p);
  EXPECT_FALSE(points[0]);
  EXPECT_TRUE(points[1]);
  EXPECT_FALSE(points[2]);
  for (const auto& point : projection::vanishing_points(a_view(false))) EXPECT_FALSE(point);
}

}  // namespace
}  // namespace epura::test::matrices_test
