// SPDX-License-Identifier: Apache-2.0
// The worked examples of the seed documents, recomputed without their rounding and misprints.
#include "support.hpp"

namespace epura::test::seeds_test {
namespace {

const double pi = std::acos(-1.0);

/// Seed 001: a unit cube turned 60 degrees about y, P1..P8 in the document's order.
Vec3 cube_corner(int i) {
  const Vec3 p{i & 4 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 1 ? 0.5 : -0.5};
  const double cosine = 0.5, sine = std::sqrt(0.75);
  return {cosine * p.x + sine * p.z, p.y, -sine * p.x + cosine * p.z};
}

TEST(seed_001, cube_reaches_the_device_through_a_look_at) {
  const projection::Projection p = make("look-at:eye=0,0,2:ref=0,0,0:vup=0,1,0:fovy=67", {{-1, -1, -1}, {1, 1, 1}});
  ASSERT_TRUE(p.window);
  const Mat4 device = projection::window_to_viewport(*p.window, {{0, 400}, {400, 0}});
  const double table[8][2] = {{86.41, 283.15},  {241.99, 314.72}, {86.41, 116.85},  {241.99, 85.28},
                              {179.39, 256.31}, {294.54, 269.21}, {179.39, 143.69}, {294.54, 130.79}};
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = cube_corner(i);
    const Vec4 h = device * image(p, corner);
    const double focal = cot(67 * pi / 360), w = 2 - corner.z;
    EXPECT_NEAR(h.x / h.w, 200 + 200 * focal * corner.x / w, 1e-11) << "P" << i + 1;
    EXPECT_NEAR(h.y / h.w, 200 - 200 * focal * corner.y / w, 1e-11) << "P" << i + 1;
    EXPECT_NEAR(h.x / h.w, table[i][0], 0.006) << "P" << i + 1;
    EXPECT_NEAR(h.y / h.w, table[i][1], 0.006) << "P" << i + 1;
  }
}

/// Seed 000: x_s, y_s, z_s by [P] and the normalised coordinates by [F], with the sign of row 3 corrected.
struct Camera {
  double l = -2, r = 3, b = -1, t = 2.5, n = 1.5, f = 40, d = 4;
  [[nodiscard]] Mat4 perspective() const {
    return rows({d, 0, 0, 0}, {0, d, 0, 0}, {0, 0, f + n, f * n}, {0, 0, -1, 0});
  }
  [[nodiscard]] Mat4 frustum() const {
    return rows({2 * d / (r - l), 0, (r + l) / (r - l), 0}, {0, 2 * d / (t - b), (t + b) / (t - b), 0},
                {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)}, {0, 0, -1, 0});
  }
};

class seed_000 : public testing::Test {
 protected:
  const Camera camera{};
  const projection::Projection p =
      make("frustum:eye=4,-9,5:ref=1,0,1:vup=0,0,1:l=-2:r=3:b=-1:t=2.5:n=1.5:f=40:d=4", a_box());
  const Mat4 eye = projection::view_orientation({4, -9, 5}, Vec3(4, -9, 5) - Vec3(1, 0, 1), {0, 0, 1});  // [C] = [R][T]
};

TEST_F(seed_000, frustum_plugin_projects_like_the_matrix_P) {
  const double e = camera.d, product = camera.f * camera.n, sum = camera.f + camera.n;
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(3, 1, 4), Vec3(-1, 12, 0.5), Vec3(4, -8, 3)}) {
    const Vec4 h = camera.perspective() * (eye * Vec4(x, 1));
    expect_near<2>(place(p, x), Vec2(h) / h.w, 1e-12);
    EXPECT_NEAR(depth(p, x), (h.z / h.w + sum) * e * e / product - e, 1e-10);
  }
}

TEST_F(seed_000, frustum_is_drawn_to_its_window_and_planes) {
  EXPECT_NEAR(p.front, camera.d - camera.n, 1e-12);
  EXPECT_NEAR(p.back, camera.d - camera.f, 1e-12);
  const Mat4 normalise = projection::window_to_viewport(*p.window, {{-1, -1}, {1, 1}});
  const Vec3 x{0.25, 2, 1.75};
  const Vec4 ours = normalise * image(p, x), theirs = camera.frustum() * (eye * Vec4(x, 1));
  expect_near<2>(Vec2(ours) / ours.w, Vec2(theirs) / theirs.w, 1e-12);
}

TEST_F(seed_000, normalised_volume_of_phigs_agrees_with_the_frustum_matrix) {
  const projection::ViewVolume volume{
      {{camera.l, camera.b}, {camera.r, camera.t}}, -camera.d, -camera.n, -camera.f, Vec3(0)};
  const Mat4 npc = projection::window_to_viewport(projection::npc_window(volume, true), {{-1, -1}, {1, 1}}) *
                   projection::m_per_npc(volume) * projection::n_per(volume) * eye;
  const Vec3 x{0.25, 2, 1.75};
  const Vec4 ours = npc * Vec4(x, 1), theirs = camera.frustum() * (eye * Vec4(x, 1));
  expect_near<2>(Vec2(ours) / ours.w, Vec2(theirs) / theirs.w, 1e-12);
}

TEST_F(seed_000, frustum_matrix_is_N_P_so_that_its_third_row_begins_with_a_minus) {
  const Camera& k = camera;
  const double depth = k.f - k.n;
  const Mat4 n =
      rows({2 / (k.r - k.l), 0, 0, -(k.r + k.l) / (k.r - k.l)}, {0, 2 / (k.t - k.b), 0, -(k.t + k.b) / (k.t - k.b)},
           {0, 0, -2 / depth, -(k.f + k.n) / depth}, {0, 0, 0, 1});
  expect_near(n * k.perspective(), k.frustum(), 1e-12);
}

class seed_002 : public testing::Test {
 protected:
  const Box box{{0, 0, 0}, {40, 60, 40}};
  const projection::Projection p =
      make("observer:o=40,60,40:c=0,20,20:u=0,20,21:d=0.5:window=-0.15,-0.1,0.15,0.1", box);
};

TEST_F(seed_002, helicopter_sees_by_the_axes_of_the_document) {
  const double root = std::sqrt(2.0);
  expect_near<3>(p.n, Vec3(2, 2, 1) / 3.0, 1e-14);
  expect_near<3>(p.v, Vec3(-1, -1, 4) / (3 * root), 1e-14);
  expect_near<3>(p.u, Vec3(-1, 1, 0) / root, 1e-14);
  expect_near<3>(p.point, Vec3(119.0 / 3, 179.0 / 3, 239.0 / 6), 1e-12);
  expect_near<3>(p.projector, Vec3(40, 60, 40), 0);
}

TEST_F(seed_002, helicopter_sees_these_points_here) {
  const double root = std::sqrt(2.0);
  expect_near<2>(place(p, {0, 20, 20}), {0, 0}, 1e-12);
  expect_near<2>(place(p, {0, 20, 21}), {0, root / 179}, 1e-12);
  expect_near<2>(place(p, {0, 0, 0}), {-root / 16, -root / 16}, 1e-12);
}

TEST_F(seed_002, depth_is_that_of_P_d) {
  const Vec3 x{3, 5, 7};
  const double z = glm::dot(x - p.point, p.n), d = 0.5;
  EXPECT_NEAR(depth(p, x), d * z / (d - z), 1e-12);
  EXPECT_NEAR(depth(p, p.point + 0.25 * p.n), d * 0.25 / (d - 0.25), 1e-11);  // before the picture
}

TEST_F(seed_002, poster_hung_high_keeps_its_window) {
  const projection::Projection poster =
      make("observer:o=40,60,40:c=0,20,20:u=0,20,21:d=0.5:window=-0.15,0.3,0.15,0.7", box);
  ASSERT_TRUE(poster.window);
  EXPECT_EQ(poster.window->min, Vec2(-0.15, 0.3));
  EXPECT_EQ(poster.window->max, Vec2(0.15, 0.7));
  // h = (h1 - h0) / (X1 - X0) (X - X0) + h0 (6.6)
  const Vec4 h = projection::window_to_viewport(*poster.window, {{0, 400}, {300, 0}}) * image(poster, {0, 0, 0});
  EXPECT_NEAR(h.x / h.w, 300 / 0.3 * (-std::sqrt(2.0) / 16 + 0.15), 1e-9);
  EXPECT_NEAR(h.y / h.w, -400 / 0.4 * (-std::sqrt(2.0) / 16 - 0.3) + 400, 1e-9);
}

TEST(seed_003, phigs_plugin_projects_like_n_per_and_n_par) {
  const projection::ViewVolume volume{{{-3, -2}, {5, 4}}, 1, 3, -9, {2, -1, 20}};
  const std::string rest = ":vrp=1,2,3:vpn=1,-2,2:vup=0,0,1:prp=2,-1,20:window=-3,-2,5,4:vpd=1:f=3:b=-9";
  const Mat4 vom = projection::view_orientation({1, 2, 3}, {1, -2, 2}, {0, 0, 1});
  const Vec4 x{0.5, 1, 2.5, 1};
  for (const bool central : {true, false}) {
    const projection::Projection p =
        make(std::string("phigs:kind=") + (central ? "perspective" : "parallel") + rest, a_box());
    const Mat4 npc =
        central ? projection::m_per_npc(volume) * projection::n_per(volume) * vom : projection::n_par(volume) * vom;
    const Mat4 back = projection::window_to_viewport(projection::npc_window(volume, central), volume.window);
    const Vec4 h = back * npc * x;
    expect_near<2>(place(p, Vec3(x)), Vec2(h) / h.w, 1e-12);
    EXPECT_EQ(p.central, central);
    EXPECT_EQ(p.front, 2);
    EXPECT_EQ(p.back, -10);
    EXPECT_EQ(p.window->min, volume.window.min);
  }
}

TEST(seed_004, look_at_of_a_cube_from_1_1_1_is_isometric) {
  const projection::Projection p = make("look-at:eye=1,1,1:ref=0,0,0:vup=0,1,0", a_box());
  expect_near<3>(p.n, Vec3(1, 1, 1) / std::sqrt(3.0), 1e-15);
  expect_near<3>(p.u, Vec3(1, 0, -1) / std::sqrt(2.0), 1e-15);
  expect_near<3>(p.v, Vec3(-1, 2, -1) / std::sqrt(6.0), 1e-15);
}

}  // namespace
}  // namespace epura::test::seeds_test
