// SPDX-License-Identifier: Apache-2.0
#include "sheet/projection_symbol.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "base/portable_math.hpp"
#include "sheet/dash.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

namespace {

// In diameters of the small end.
constexpr double large = 2, cone_length = 2, views_apart = 1;
constexpr double past_outlines = 0.3;  // centre lines extend beyond the outlines
constexpr double whole_length = cone_length + views_apart + large;
constexpr int corners_of_face = 96;

Stroke circle(const Vec2& centre, double radius) {
  Stroke stroke;
  stroke.closed = true;
  for (int i = 0; i < corners_of_face; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners_of_face;
    stroke.points.push_back(centre + radius * Vec2(portable_cos(angle), portable_sin(angle)));
  }
  stroke.curves = {{0, corners_of_face, centre, {radius, 0}, {0, radius}, 0, 2 * std::numbers::pi}};
  return stroke;
}

Stroke centre_line(const Vec2& from, const Vec2& to) {
  Stroke stroke = line(from, to);
  stroke.dashes = fit_open(glm::length(to - from), narrow_line, scene::long_dash_dot);
  return stroke;
}

}  // namespace

Vec2 projection_symbol_size(double height) {
  return Vec2(whole_length + 2 * past_outlines, large + 2 * past_outlines) * height;
}

Furniture projection_symbol(ProjectionAngle angle, double height, const Vec2& centre) {
  const double h = height;
  const double side = angle == ProjectionAngle::first ? -1 : 1;  // of the cone
  const Vec2 cone = centre + Vec2(side * (whole_length - cone_length) / 2 * h, 0);
  const Vec2 circles = centre - Vec2(side * (whole_length - large) / 2 * h, 0);
  const double end = cone_length / 2 * h, reach = (large / 2 + past_outlines) * h;
  Furniture symbol;
  symbol.medium = {{{cone + Vec2(-end, h / 2), cone + Vec2(-end, -h / 2), cone + Vec2(end, -large / 2 * h),
                     cone + Vec2(end, large / 2 * h)},
                    true},
                   circle(circles, h / 2),
                   circle(circles, large / 2 * h)};
  symbol.narrow = {centre_line(cone - Vec2(end + past_outlines * h, 0), cone + Vec2(end + past_outlines * h, 0)),
                   centre_line(circles - Vec2(reach, 0), circles + Vec2(reach, 0)),
                   centre_line(circles - Vec2(0, reach), circles + Vec2(0, reach))};
  return symbol;
}

void add_gravity_symbol(Layer& layer, const Vec2& centre, double radius) {
  constexpr int parts = 16;
  constexpr double quarter = std::numbers::pi / 2;
  layer.strokes.push_back(circle_at(centre, radius));
  for (const double begin : {quarter, -quarter}) {
    Fill& fill = layer.fills.emplace_back();
    std::vector<Vec2>& ring = fill.rings.emplace_back();
    ring.push_back(centre);
    for (int i = 0; i <= parts; ++i) ring.push_back(centre + radius * turned_to(begin + quarter * i / parts));
  }
}

}  // namespace epura::sheet
