// SPDX-License-Identifier: Apache-2.0
// Projections: the position of the viewer.
#include <cmath>

#include "study/stability/case.hpp"
#include "study/stability/exact_places.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

world::World cube_at(const Lab& lab, double d) { return lab.world_of(box({d, d, d}, {d + 1, d + 1, d + 1})); }

Measured mirrored(const Lab& lab, double degrees) {
  Shape shape = box({0, 0, 0}, {1, 2, 3});
  shape.add(box({0.5, -1, 0.2}, {2, 0.5, 0.7}));
  const double a = degrees * M_PI / 180;
  const Result plain = lab.exact().draw(lab.world_of(shape), {orthographic({std::sin(a), -std::cos(a), 0.4})});
  for (Point& p : shape.points) p[0] = -p[0];
  const Result result = lab.draw(lab.world_of(shape), {orthographic({-std::sin(a), -std::cos(a), 0.4})});
  Measured measured = lengths(result, plain.visible(), plain.hidden_length());
  measured.push_back(count("visible pieces", plain.pieces(true), result.pieces(true)));
  return measured;
}

Measured moved_together(const Lab& lab, double exponent) {
  const double d = std::ldexp(1.0, static_cast<int>(exponent));
  const Vec3 eye(3, -4, 2), normal(1, -2, 0.5), up(0, 0, 1);
  const Result plain = lab.exact().draw(cube_at(lab, 0), {perspective(eye, Vec3(0), normal, up)});
  const Result result = lab.draw(cube_at(lab, d), {perspective(eye + d, Vec3(d), normal, up)});
  Measured measured = lengths(result, plain.visible(), plain.hidden_length());
  measured.push_back(places(result));
  return measured;
}

// The plate appears as a line in front of the cube's front face and hides nothing of it: 4 edges and the plate's near
// edge. The cube's rear face, and the edges to it, lie behind its front face.
Measured eye_in_the_plane_of_a_plate(const Lab& lab, double e) {
  const world::World world = lab.world_of({plate(-1, 1, 1, 2, 0), box({-0.5, 4, -0.5}, {0.5, 5, 0.5})});
  return lengths(lab.draw(world, {perspective({0, 0, e}, {0, 1, e}, {0, -1, 0}, {0, 0, 1})}), 3,
                 0.8 + 0.1 * std::sqrt(2.0));
}

// A square of side 1 at distance 4, and a plate below the eye that extends half as far. The plate's far edge is e / 2
// below the horizon on the page; while the eye is above the plate, everything below that edge is hidden.
Measured eye_over(const Lab& lab, const Shape& floor, double e, double visible, double hidden) {
  const Shape target{
      {{-0.5, 4, e - 0.5}, {0.5, 4, e - 0.5}, {0.5, 4, e + 0.5}, {-0.5, 4, e + 0.5}}, {{0, 1, 2, 3}}, {}};
  projection::Projection p = perspective({0, 0, e}, {0, 1, e}, {0, -1, 0}, {0, 0, 1});
  p.window = projection::Window{{-0.5, -0.5}, {0.5, 0.5}};
  return lengths(lab.draw(lab.world_of({floor, target}), {p}), visible, hidden);
}

// The plate ends on the right below the eye, or extends around it.
Measured eye_on_a_plate(const Lab& lab, double e) {
  const Shape corner{{{-1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {-1, 2, 0}}, {{0, 1, 2, 3}}, {}};
  const Shape around{{{-1, -1, 0}, {1, -1, 0}, {1, 2, 0}, {-1, 2, 0}}, {{0, 1, 2, 3}}, {}};
  const bool over = e > 0;
  Measured measured = eye_over(lab, corner, e, over ? 1.75 : 1.5, over ? 0.25 - e / 2 : 0);
  append(measured, eye_over(lab, around, e, over ? 1.5 + e : 2, over ? 0.5 - e : 0));
  return measured;
}

// The eye is 3 in front of the cube. The far face remains, and the walls from the near plane to it.
Measured near_plane_through_a_cube(const Lab& lab, double left) {
  const double far = 4, near = far - left;
  const projection::Projection p = perspective({0.5, -3, 0.5}, {0.5, -2, 0.5}, {0, -1, 0}, {0, 0, 1});
  const Result result = lab.draw(cube_at(lab, 0), {p, {.near = near, .far = {}}});
  return lengths(result, 4 / far + 2 * std::sqrt(2.0) * (1 / near - 1 / far), 0);
}

Measured far_eye(const Lab& lab, double h) {
  return lengths(lab.draw(cube_at(lab, 0), {perspective(Vec3(h), Vec3(0), Vec3(1), {0, 0, 1})}), 9 * isometric_edge,
                 3 * isometric_edge, 1e-9);
}

}  // namespace

std::vector<Case> viewer_cases() {
  return {
      {"P11", "mirrored model gives the mirrored drawing", "degrees", {5, 10, 20, 30, 40, 50, 60, 70, 80}, mirrored},
      {"P12", "scene and eye moved together by 2^j", "j", {0, 8, 16, 20, 24, 30, 36, 40, 45, 50}, moved_together},
      {"P13",
       "eye in the plane of a plate",
       "eye over the plate",
       {1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 0},
       eye_in_the_plane_of_a_plate},
      {"P14",
       "eye on a vertex or in a triangle",
       "eye over the plate",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0},
       eye_on_a_plate},
      {"P15",
       "near plane through a cube",
       "depth that is left",
       {0.9, 0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8},
       near_plane_through_a_cube},
      {"P16",
       "eye so far away that all distances are one",
       "distance",
       {1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17},
       far_eye},
  };
}

}  // namespace epura::stability
