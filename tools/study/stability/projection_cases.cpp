// SPDX-License-Identifier: Apache-2.0
// Projections: algorithms of the map itself.
#include <algorithm>
#include <cmath>

#include "study/stability/case.hpp"
#include "study/stability/exact_places.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

const double root2 = std::sqrt(2.0);

world::World cube(const Lab& lab) { return lab.world_of(box({0, 0, 0}, {1, 1, 1})); }

// The eye at height h above the far face z = 0 of the unit cube, with the picture plane through the near face z = 1.
projection::Projection over_the_cube(double h) {
  return perspective({0.5, 0.5, h}, {0.5, 0.5, 1}, {0, 0, 1}, {0, 1, 0});
}

// The far face is a square of side (h - 1) / h inside that of the near face, and four edges join their corners. If the
// two are too close to be distinguished, only one is left.
Measured from_the_axis(const Lab& lab, double h) {
  const Result result = lab.draw(cube(lab), {over_the_cube(h)});
  const bool merged = 0.5 / h < result.merge_width();
  Measured measured = lengths(result, 4, merged ? 0 : 4 * ((h - 1) / h) + 2 * root2 / h);
  measured.push_back(places(result));
  return measured;
}

Measured by_field_of_view(const Lab& lab, double degrees) {
  return from_the_axis(lab, 1 + 0.5 / std::tan(degrees * M_PI / 360));
}

Measured open_box(const Lab& lab, double over) {
  const double h = 1 + over;
  Shape open = box({0, 0, 0}, {1, 1, 1});
  open.faces.erase(open.faces.begin() + 1);  // the near face z = 1
  const Result result = lab.draw(lab.world_of(open), {over_the_cube(h)});
  const bool merged = 0.5 / h < result.merge_width();
  return lengths(result, merged ? 4 : 4 + 4 * ((h - 1) / h) + 2 * root2 / h, 0);
}

// The eye is in the middle of a room; the far wall is 2 x 2 on a picture plane through it.
Measured room_from_inside(const Lab& lab, double a) {
  projection::Projection inside = perspective({0, 0, 0}, {0, 0, -2}, {0, 0, 1}, {0, 1, 0});
  inside.window = projection::Window{{-a, -a}, {a, a}};
  const Result result = lab.draw(lab.world_of(box({-1, -1, -2}, {1, 1, 5})), {inside});
  return lengths(result, 8 + 4 * root2 * (a - 1), 0);
}

Measured floor_to_the_eye(const Lab& lab, double near) {
  projection::Projection p = perspective({0, 0, 1}, {0, 1, 1}, {0, -1, 0}, {0, 0, 1});
  p.window = projection::Window{{-1, -1}, {1, 1}};
  const Shape floor{{{-1, -5, 0}, {1, -5, 0}, {1, 10, 0}, {-1, 10, 0}}, {{0, 1, 2, 3}}, {}};
  return lengths(lab.draw(lab.world_of(floor), {p, {.near = near, .far = {}}}), 1.8 * root2 + 0.2, 0);
}

// Plates, each ten times nearer than the last, of equal size on the page, each shifted over the one behind it.
Measured plates_over_decades(const Lab& lab, double decades) {
  const int plates = static_cast<int>(decades) + 1;
  const double d = 0.01;
  Shape all;
  for (int i = 0; i < plates; ++i) {
    const double shift = d * (plates - 1 - i);
    all.add(plate(shift, shift, 1 + shift, 1 + shift, -1).scaled(std::pow(10.0, 6 - i)));
  }
  const Result result = lab.draw(lab.world_of(all), {perspective({0, 0, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0})});
  const double visible = 2 * plates + 2 + 2 * d * (plates - 1);
  return {length("visible", visible, result.visible(), visible), places(result)};
}

// Sleepers at distance 2^j between rails one unit to the left and right, and one unit below the eye.
Measured rails(const Lab& lab, double doublings) {
  const int last = static_cast<int>(doublings);
  Shape track;
  for (int j = 0; j <= last; ++j) {
    const double y = std::ldexp(1.0, j);
    track.points.push_back({-1, y, -1});
    track.points.push_back({1, y, -1});
    if (j > 0) track.faces.push_back({2 * j - 2, 2 * j - 1, 2 * j + 1, 2 * j});
  }
  const Camera camera{perspective({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1})};
  const Result result = lab.draw(lab.world_of(track), camera, {.smooth = true});
  const double along = 2 * root2 * (1 - std::ldexp(1.0, -last));
  return lengths(result, along + 4 * (1 - std::ldexp(1.0, -(last + 1))), 0);
}

// Not at 45 degrees, where the hidden receding edge would extend under a visible one.
Measured oblique_cube(const Lab& lab, double l) {
  projection::Projection p = orthographic({0, -1, 0});
  p.projector = {l * std::cos(0.4), -1, l * std::sin(0.4)};
  const Result result = lab.draw(cube(lab), {p});
  Measured measured = lengths(result, 6 + 3 * l, 2 + l);
  measured.push_back(places(result));
  return measured;
}

// A plane perpendicular to an axis, so that its point is moved exactly in it.
Measured shifted_principal_point(const Lab& lab, double shift) {
  projection::Projection p = perspective({3, -4, 2}, {0, 0, 0}, {0, -1, 0}, {0, 0, 1});
  const Result plain = lab.exact().draw(cube(lab), {p});
  p.point.x = shift;
  const Result result = lab.draw(cube(lab), {p});
  Measured measured = lengths(result, plain.visible(), plain.hidden_length());
  measured.push_back(places(result));
  return measured;
}

double largest_change(const drawing::ViewDrawing& a, const drawing::ViewDrawing& b, double factor) {
  if (a.segments.size() != b.segments.size()) return HUGE_VAL;
  double change = 0;
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    const drawing::Segment& s = a.segments[i];
    const drawing::Segment& t = b.segments[i];
    if (s.visible != t.visible) return HUGE_VAL;
    change = std::max({change, glm::distance(s.from * factor, t.from), glm::distance(s.to * factor, t.to)});
  }
  return change;
}

// M_per is linear in the normal of the plane: scaling the normal scales the matrix by the same factor (seed 003, 3.10).
Measured multiplied_matrix(const Lab& lab, double factor) {
  Camera camera{perspective({3, -4, 2}, {0.5, 0.5, 0.5}, {1, -2, 0.5}, {0, 0, 1})};
  const Result plain = lab.draw(cube(lab), camera);
  camera.factor = factor;
  const Result result = lab.draw(cube(lab), camera);
  int exponent = 0;
  const bool power_of_two = std::abs(std::frexp(factor, &exponent)) == 0.5;
  return {length("places", 0, largest_change(plain.drawing, result.drawing, 1), plain.view.extent,
                 power_of_two ? 0 : 1e-12)};
}

}  // namespace

std::vector<Case> projection_cases() {
  const std::vector<double> near_and_far{1,   1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e1,
                                         1e2, 1e4,  1e6,  1e7,  1e10, 1e12, 1e14,  1e16};
  const std::vector<double> fields_of_view{50,   10,  1,   1e-1, 1e-2,  1e-3,   1e-4,   1e-5,
                                           1e-6, 120, 170, 179,  179.9, 179.99, 179.999};
  const auto over = [](const Lab& lab, double d) { return from_the_axis(lab, 1 + d); };
  return {
      {"P1", "unit cube from its axis, the eye near or far", "eye over the plane", near_and_far, over},
      {"P2", "unit cube from its axis by field of view", "degrees", fields_of_view, by_field_of_view},
      {"P3", "open box: back faces are seen", "eye over the plane", near_and_far, open_box},
      {"P4",
       "room from inside",
       "half of the window",
       {2, 1.25, 1 + 1e-2, 1 + 1e-4, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6},
       room_from_inside},
      {"P5",
       "floor through the plane of the eye",
       "near",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12},
       floor_to_the_eye},
      {"P6", "plates over decades of depth", "decades", {1, 2, 4, 6, 8, 10, 12, 14, 16}, plates_over_decades},
      {"P7", "rails and sleepers to the horizon", "doublings of distance", {1, 2, 4, 8, 12, 16, 20, 30, 40}, rails},
      {"P8",
       "oblique cube, projectors nearly in the plane",
       "depth ratio",
       {0.5, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6},
       oblique_cube},
      {"P9",
       "principal point shifted off the page",
       "shift",
       {1, 1e2, 1e4, 1e6, 1e8, 1e9, 1e10, 1e11, 1e12},
       shifted_principal_point},
      {"P10",
       "matrix times a number",
       "factor",
       {2, -1, 0x1p60, 0x1p-60, 1e30, 1e-30, 1e150, 1e-150, 0x1p1000, 0x1p-1000},
       multiplied_matrix},
  };
}

}  // namespace epura::stability
