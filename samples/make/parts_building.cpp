// SPDX-License-Identifier: Apache-2.0
// Things to look at in perspective: a house, a staircase, and a height field.
#include <cmath>
#include <numbers>

#include "parts.hpp"

namespace samples {

namespace {

constexpr double width = 9000, depth = 7000, eaves = 2800, ridge = 5600;

/// A window `x, z` wide and high at a corner: a recess whose back holds four panes, set back once more.
Loop window(Solid& wall, const Frame& frame, const Point2& corner, const Point2& size) {
  const Point inwards = -1.0 * cross(frame.u, frame.v);
  const Loop opening = place(rectangle(corner[0], corner[1], corner[0] + size[0], corner[1] + size[1]), frame);
  wall.bore(opening, 150.0 * inwards);
  constexpr double bar = 60;
  const double w = (size[0] - 3 * bar) / 2, h = (size[1] - 3 * bar) / 2;
  std::vector<Loop> panes;
  for (const double x : {corner[0] + bar, corner[0] + w + 2 * bar}) {
    for (const double z : {corner[1] + bar, corner[1] + h + 2 * bar}) {
      panes.push_back(shifted(place(rectangle(x, z, x + w, z + h), frame), 150.0 * inwards));
      wall.bore(panes.back(), 50.0 * inwards);
      wall.face(shifted(panes.back(), 50.0 * inwards));
    }
  }
  wall.face(shifted(opening, 150.0 * inwards), panes);
  return opening;
}

Loop door(Solid& wall, const Frame& frame) {
  const Point inwards = -1.0 * cross(frame.u, frame.v);
  const Loop opening = place(rectangle(3900, 150, 5000, 2300), frame);
  const Loop leaf = shifted(opening, 150.0 * inwards);
  const Loop light = shifted(place(rectangle(4150, 1500, 4750, 2100), frame), 150.0 * inwards);
  wall.bore(opening, 150.0 * inwards);
  wall.face(leaf, {light});
  wall.bore(light, 40.0 * inwards);
  wall.face(shifted(light, 40.0 * inwards));
  return opening;
}

/// A round window in a gable.
Loop round_window(Solid& wall, const Frame& frame) {
  const Point inwards = -1.0 * cross(frame.u, frame.v);
  const Loop opening = place(circle(450, 48, {depth / 2, 3900}), frame);
  wall.bore(opening, 150.0 * inwards);
  wall.face(shifted(opening, 150.0 * inwards));
  return opening;
}

Solid walls() {
  const Frame front = seen_from_front({0, 0, 0}), right = seen_from_right({width, 0, 0});
  const Frame back = seen_from_back({width, depth, 0}), left = seen_from_left({0, depth, 0});
  const Outline gable = {{0, 0}, {depth, 0}, {depth, eaves}, {depth / 2, ridge}, {0, eaves}};
  const Loop west = place(gable, left), east = place(gable, right);
  const Outline side = rectangle(0, 0, width, eaves);

  Solid solid("walls");
  solid.face(place(side, front), {window(solid, front, {900, 900}, {1500, 1300}), door(solid, front),
                                  window(solid, front, {6400, 900}, {1500, 1300})});
  solid.face(east, {window(solid, right, {1000, 900}, {1200, 1300}), window(solid, right, {4800, 900}, {1200, 1300}),
                    round_window(solid, right)});
  solid.face(place(side, back),
             {window(solid, back, {1500, 900}, {1500, 1300}), window(solid, back, {5800, 900}, {1500, 1300})});
  solid.face(west, {round_window(solid, left)});
  solid.face({east[4], east[3], west[3], west[2]});
  solid.face({east[3], east[2], west[4], west[3]});
  solid.face({east[1], east[0], west[1], west[0]});
  return solid;
}

Solid roof() {
  constexpr double overhang = 500, thickness = 250, slope = (ridge - eaves) / (depth / 2);
  constexpr double low = eaves - overhang * slope;
  const Outline chevron = {{-overhang, low},
                           {depth / 2, ridge},
                           {depth + overhang, low},
                           {depth + overhang, low + thickness},
                           {depth / 2, ridge + thickness},
                           {-overhang, low + thickness}};
  Solid solid("roof");
  solid.prism(place(chevron, seen_from_right({-400, 0, 0})), {width + 800, 0, 0});
  return solid;
}

/// It stands in the house and passes through the roof; its flue is open at the top.
Solid chimney() {
  constexpr double top = 6700, flue = 800;
  const Loop outer = place(rectangle(6300, 1700, 7200, 2500), seen_from_top({0, 0, 0}));
  const Loop inner = place(rectangle(6500, 1900, 7000, 2300), seen_from_top({0, 0, top}));
  Solid solid("chimney");
  const Loop bottom = shifted(outer, {0, 0, 3500}), rim = shifted(outer, {0, 0, top});
  solid.face(reversed(bottom));
  solid.strip(bottom, rim);
  solid.face(rim, {inner});
  solid.bore(inner, {0, 0, -flue});
  solid.face(shifted(inner, {0, 0, -flue}));
  return solid;
}

}  // namespace

Model house() {
  Solid step("step");
  step.prism(place(rectangle(3500, -900, 5400, 0), seen_from_top({0, 0, 0})), {0, 0, 150});
  return {walls(), roof(), chimney(), step};
}

namespace {

constexpr double step_angle = 22.5, step_rise = 180;

Solid tread(int number) {
  const double from = number * step_angle;
  Outline outline = arc({0, 0}, 900, from, from + 26, 8);
  const Outline inside = arc({0, 0}, 60, from + 26, from, 8);
  outline.insert(outline.end(), inside.begin(), inside.end());
  Solid solid("tread_" + std::to_string(number + 1));
  solid.prism(place(outline, seen_from_top({0, 0, (number + 1) * step_rise - 45})), {0, 0, 45});
  return solid;
}

Solid upright(const std::string& name, const Point& foot, double radius, double height, int segments) {
  Solid solid(name);
  solid.prism(ring(seen_from_top(foot), radius, segments), {0, 0, height});
  return solid;
}

/// A round bar along the helix through the tops of the posts.
Solid handrail(int treads, double radius, double height) {
  constexpr int parts = 4, segments = 16;
  constexpr double rise = step_rise / step_angle;
  std::vector<Loop> loops;
  for (int i = 0; i <= (treads - 1) * parts; ++i) {
    const double angle = step_angle * (0.5 + static_cast<double>(i) / parts);
    const Point out = {cos_deg(angle), sin_deg(angle), 0};
    const Point along = {-radius * sin_deg(angle), radius * cos_deg(angle), rise * 180 / std::numbers::pi};
    const Point tangent = (1 / std::sqrt(dot(along, along))) * along;
    const Point centre = radius * out + Point{0, 0, height + rise * (angle + step_angle / 2)};
    loops.push_back(ring({centre, out, cross(tangent, out)}, 22, segments));
  }
  Solid solid("handrail");
  solid.rings(loops, false);
  return solid;
}

}  // namespace

Model stairs() {
  constexpr int treads = 14;
  constexpr double rail_radius = 850, rail_height = 900;
  Model model = {upright("column", {0, 0, 0}, 90, treads * step_rise + 1000, 48)};
  for (int i = 0; i < treads; ++i) {
    model.push_back(tread(i));
    const double angle = (i + 0.5) * step_angle;
    const Point foot = {rail_radius * cos_deg(angle), rail_radius * sin_deg(angle), (i + 1) * step_rise};
    model.push_back(upright("post_" + std::to_string(i + 1), foot, 10, rail_height, 16));
  }
  model.push_back(handrail(treads, rail_radius, rail_height));
  return model;
}

Model sombrero() {
  constexpr int cells = 48;
  constexpr double reach = 4, unit = 25;  // the drawn square is 2 * reach wide; `unit` mm stand for 1
  constexpr double height = 3 * unit;
  const auto point = [](int i, int j) -> Point {
    const double x = reach * (2.0 * i / cells - 1), y = reach * (2.0 * j / cells - 1);
    const double a = std::numbers::pi * std::sqrt(x * x + y * y);
    return {unit * x, unit * y, height * (a == 0 ? 1 : std::sin(a) / a)};
  };
  Solid surface("sombrero");
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      surface.face({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  return {surface};
}

}  // namespace samples
