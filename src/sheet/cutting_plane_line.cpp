// SPDX-License-Identifier: Apache-2.0
#include "sheet/cutting_plane_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/portable_math.hpp"
#include "sheet/dash.hpp"

namespace epura::sheet {

namespace {

// Lengths in multiples of the letter height, which is 20 narrow line widths: 5 mm for lines of 0.25 mm.
constexpr double letter_widths = 20;
constexpr double past_outline = 0.8;
constexpr double wide_end = 1.4;
constexpr double arrow_length = 2, head_length = 0.7;
constexpr double head_half_angle = 15;  // degrees
constexpr double letter_gap = 0.3;
constexpr double edge_on = 1e-9;  // radians

Vec2 on_page(const Mat4& world_to_page, const Vec3& p) {
  const Vec4 page = world_to_page * Vec4(p, 1);
  return Vec2(page) / page.w;
}

// In the world: along the plane, and perpendicular to the projectors.
Vec3 along_trace(const projection::Projection& projection, const scene::CuttingPlane& plane) {
  return glm::cross(glm::normalize(projection.projector), plane.normal);
}

/// The image of a plane seen edge-on.
struct Trace {
  Vec2 point, along;
  Vec2 seen;        ///< viewing direction of the section: perpendicular to the line
  double from, to;  ///< of the ink along the line, from the point
};

std::optional<Trace> trace_of(const drawing::ViewDrawing& parent, const scene::CuttingPlane& plane) {
  if (!sees_edge_on(parent.projection, plane)) return std::nullopt;
  const Mat4& map = parent.world_to_page;
  Trace trace{on_page(map, plane.point), Vec2(0), Vec2(0), HUGE_VAL, -HUGE_VAL};
  const auto direction = [&](const Vec3& v) { return Vec2(map * Vec4(v, 0)); };
  trace.along = glm::normalize(direction(along_trace(parent.projection, plane)));
  trace.seen = {-trace.along.y, trace.along.x};
  if (glm::dot(trace.seen, direction(plane.normal)) > 0) trace.seen = -trace.seen;
  for (const drawing::Segment& segment : parent.segments)
    for (const Vec2& p : {segment.from, segment.to}) {
      trace.from = std::min(trace.from, glm::dot(p - trace.point, trace.along));
      trace.to = std::max(trace.to, glm::dot(p - trace.point, trace.along));
    }
  if (!(trace.from <= trace.to)) return std::nullopt;
  return trace;
}

/// The corners of a box around the line a, b.
Fill wide_line(const Vec2& a, const Vec2& b, double width) {
  const Vec2 along = glm::normalize(b - a) * (width / 2);
  const Vec2 across(-along.y, along.x);
  return {{{a + across, a - across, b - across, b + across}}};
}

Fill arrow_head(const Vec2& tip, const Vec2& pointing, double length) {
  const Vec2 across = Vec2(-pointing.y, pointing.x) * (length * portable_tan(head_half_angle * std::numbers::pi / 180));
  const Vec2 foot = tip - length * pointing;
  return {{{tip, foot + across, foot - across}}};
}

// The end of the line to which its direction points, or (-1) from which it comes.
Vec2 end_of(const Trace& trace, double side, double height) {
  const double past = (past_outline + wide_end) * height;
  return trace.point + (side < 0 ? trace.from - past : trace.to + past) * trace.along;
}

// Adds one end of the line: the one to which its direction points, or (-1) from which it comes.
void add_end(Layer& layer, const Trace& trace, double side, const std::string& name, const LineWidths& widths) {
  const Vec2 outwards = side * trace.along;
  const double height = letter_widths * widths.narrow;
  const Vec2 end = end_of(trace, side, height);
  layer.fills.push_back(wide_line(end, end - wide_end * height * outwards, widths.wide));
  // The tip of the arrow touches the edge of the wide line.
  const Vec2 tip = end - (wide_end / 2 * height) * outwards - (widths.wide / 2) * trace.seen;
  const Vec2 tail = tip - arrow_length * height * trace.seen;
  layer.fills.push_back(arrow_head(tip, trace.seen, head_length * height));
  layer.strokes.push_back({{tail, tip - head_length * height * trace.seen}});
  // Letters are upright whatever the direction of the line.
  const Vec2 middle = tail + (letter_gap + 0.5) * height * outwards;
  layer.texts.push_back({name, middle - Vec2(0, height / 2), height, 0, Align::middle, "section"});
}

}  // namespace

bool sees_edge_on(const projection::Projection& projection, const scene::CuttingPlane& plane) {
  return !projection.central && std::abs(glm::dot(glm::normalize(projection.projector), plane.normal)) <= edge_on;
}

Vec2 cutting_plane_room(const projection::Projection& projection, const scene::CuttingPlane& plane,
                        const LineWidths& widths) {
  const Vec3 trace = along_trace(projection, plane), p = projection.projector;
  const Vec3 image = trace - glm::dot(trace, projection.n) / glm::dot(p, projection.n) * p;
  const Vec2 along = glm::normalize(Vec2(glm::dot(image, projection.u), glm::dot(image, projection.v)));
  return (past_outline + wide_end / 2 + letter_gap + 1) * letter_widths * widths.narrow * glm::abs(along);
}

std::optional<Layer> cutting_plane_line(const drawing::ViewDrawing& parent, const scene::CuttingPlane& plane,
                                        const LineWidths& widths) {
  const auto trace = trace_of(parent, plane);
  if (!trace) return std::nullopt;
  const double height = letter_widths * widths.narrow;
  const Vec2 from = end_of(*trace, -1, height), to = end_of(*trace, 1, height);
  Layer layer = empty_layer(parent.name, scene::SheetLine::cutting_plane, widths);
  Stroke chain{{from + wide_end * height * trace->along, to - wide_end * height * trace->along}};
  chain.dashes = fit_open(glm::distance(chain.points[0], chain.points[1]), widths.narrow, scene::long_dash_dot);
  layer.strokes.push_back(chain);
  add_end(layer, *trace, -1, plane.name, widths);
  add_end(layer, *trace, 1, plane.name, widths);
  return layer;
}

}  // namespace epura::sheet
