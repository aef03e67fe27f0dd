// SPDX-License-Identifier: Apache-2.0
#include "annotations/cutting_plane_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "annotations/sight_arrows.hpp"
#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "sheet/boxes.hpp"
#include "sheet/dash.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

// Lengths in heights of the letters.
constexpr double past_ink = 0.8;
constexpr double wide_end = 1.4;
constexpr double arrow_length = 2, head_length = 0.7;
constexpr double letter_gap = 0.3;
constexpr double wide_turn = 0.7;
constexpr double max_outer_corner = 3;     // half widths of the line
constexpr double seen_edge_on = 1e-9;      // radians
constexpr double past_dividing = 3;        // mm; ISO 128-2: centre lines end past the outline
constexpr double on_dividing_line = 0.05;  // mm
constexpr double shortest_rest = 1;        // mm, of a centre line

// In the world: along the plane, and perpendicular to the projectors.
Vec3 along_trace(const projection::Projection& projection, const scene::CuttingPlane& plane) {
  return glm::cross(glm::normalize(projection.projector), plane.normal);
}

struct LineExtent {
  double from = HUGE_VAL, to = -HUGE_VAL;
};

// Of the ink of a view along a direction, from a point.
LineExtent extent_of(const drawing::ViewDrawing& view, const Vec2& point, const Vec2& along) {
  LineExtent extent;
  for (const drawing::Segment& segment : view.segments)
    for (const Vec2& p : {segment.from, segment.to}) {
      extent.from = std::min(extent.from, glm::dot(p - point, along));
      extent.to = std::max(extent.to, glm::dot(p - point, along));
    }
  return extent;
}

/// The image of a cutting surface seen edge-on.
struct Trace {
  std::vector<Vec2> corners;  ///< ends past the ink
  std::vector<Vec2> legs;     ///< unit vectors from corner to corner
  std::array<Vec2, 2> seen;   ///< viewing directions of the section at both ends: perpendicular to the planes
};

// How far the ink of a view is along a ray.
std::optional<double> reach_along(const drawing::ViewDrawing& view, const Vec2& point, const Vec2& along) {
  const Vec2 across(-along.y, along.x);
  std::optional<double> reach;
  for (const drawing::Segment& segment : view.segments) {
    const double a = glm::dot(segment.from - point, across), b = glm::dot(segment.to - point, across);
    if ((a > on_dividing_line && b > on_dividing_line) || (a < -on_dividing_line && b < -on_dividing_line)) continue;
    const double part = std::abs(a - b) > on_dividing_line ? std::clamp(a / (a - b), 0.0, 1.0) : 0;
    const double at = glm::dot(segment.from + part * (segment.to - segment.from) - point, along);
    if (at > 0) reach = std::max(reach.value_or(0), at);
  }
  return reach;
}

// The viewing direction at a plane: perpendicular to its line on the page, away from what is removed.
Vec2 sight_at(const Mat4& map, const scene::CuttingPlane& plane, const Vec2& along) {
  const Vec2 seen(-along.y, along.x);
  return glm::dot(seen, Vec2(map * Vec4(plane.normal, 0))) > 0 ? -seen : seen;
}

std::optional<Trace> trace_of(const drawing::ViewDrawing& parent, const cut::CuttingSurface& surface, double height,
                              double farther) {
  if (!sees_edge_on(parent.projection, surface)) return std::nullopt;
  const Mat4& map = parent.world_to_page;
  const scene::CuttingPlane& plane = surface.plane;
  const auto direction = [&](const Vec3& v) { return Vec2(map * Vec4(v, 0)); };
  const double past = (past_ink + wide_end) * height + farther;
  const Vec2 along = glm::normalize(direction(along_trace(parent.projection, plane)));
  const Vec2 seen = sight_at(map, plane, along);
  Trace trace{{}, {}, {seen, seen}};
  if (surface.is_plane()) {
    const Vec2 point = drawing::position_on_page(parent, plane.point);
    const LineExtent ink = extent_of(parent, point, along);
    if (!(ink.from <= ink.to)) return std::nullopt;
    trace.legs = {along};
    trace.corners = {point + (ink.from - past) * along, point + (ink.to + past) * along};
    return trace;
  }
  for (const Vec3& corner : surface.path) trace.corners.push_back(drawing::position_on_page(parent, corner));
  const std::size_t last = trace.corners.size() - 1;
  for (const auto& [end, next] : {std::pair(std::size_t{0}, std::size_t{1}), std::pair(last, last - 1)}) {
    const Vec2 outwards = glm::normalize(trace.corners[end] - trace.corners[next]);
    LineExtent ink = extent_of(parent, trace.corners[next], outwards);
    if (!(ink.from <= ink.to)) return std::nullopt;
    if (surface.aligned) {
      // An inclined line past all of the ink would be too long.
      ink.to = reach_along(parent, trace.corners[next], outwards).value_or(ink.to);
      trace.seen[end == 0 ? 0 : 1] =
          sight_at(map, *(end == 0 ? surface.regions.front() : surface.regions.back()).plane, outwards);
    }
    trace.corners[end] = trace.corners[next] + (std::max(ink.to, wide_turn * height) + past) * outwards;
  }
  for (std::size_t leg = 0; leg < last; ++leg)
    trace.legs.push_back(glm::normalize(trace.corners[leg + 1] - trace.corners[leg]));
  check(trace.legs.size() + 1 == trace.corners.size(), "a leg leads from corner to corner");
  return trace;
}

/// The corners of a box around the line a, b.
Fill wide_stroke(const Vec2& a, const Vec2& b, double width) {
  const Vec2 along = glm::normalize(b - a) * (width / 2);
  const Vec2 across(-along.y, along.x);
  return {{{a + across, a - across, b - across, b + across}}};
}

// Adds one end of the line.
void add_end(Layer& layer, const Vec2& end, const Vec2& outwards, const Vec2& seen, const LineWidths& widths,
             const std::string& name) {
  const double height = letter_widths * widths.narrow;
  layer.fills.push_back(wide_stroke(end, end - wide_end * height * outwards, widths.wide));
  const auto add_letter = [&](const Vec2& middle) {
    // Letters are upright whatever the direction of the line.
    layer.texts.push_back({name, middle - Vec2(0, height / 2), height, 0, Align::middle, "section"});
  };
  const bool is_step = std::abs(glm::dot(outwards, seen)) > 0.5;
  if (is_step) return add_letter(end + (letter_gap + 0.5) * height * outwards);
  // The tip of the arrow touches the edge of the wide line.
  const Vec2 tip = end - (wide_end / 2 * height) * outwards - (widths.wide / 2) * seen;
  const Vec2 tail = tip - arrow_length * height * seen;
  layer.fills.push_back(sight_head(tip, seen, head_length * height));
  layer.strokes.push_back({{tail, tip - head_length * height * seen}});
  add_letter(tail + (letter_gap + 0.5) * height * outwards);
}

// Adds the wide parts of the legs next to a corner, which overlap in it.
void add_turn(Layer& layer, const Trace& trace, std::size_t corner, const LineWidths& widths, double wide) {
  const Vec2& at = trace.corners[corner];
  const Vec2 &in = trace.legs[corner - 1], &out = trace.legs[corner];
  // Up to the outer corner, unless that is far away: the tangent of half the turn.
  const double tangent = std::abs(cross(in, out)) / (1 + glm::dot(in, out));
  const double outer = std::min(tangent, max_outer_corner) * widths.wide / 2;
  for (const Vec2& other : {trace.corners[corner - 1], trace.corners[corner + 1]}) {
    const Vec2 along = glm::normalize(other - at);
    const double length = std::min(wide, glm::distance(other, at) / 2);
    layer.fills.push_back(wide_stroke(at - outer * along, at + length * along, widths.wide));
  }
}

// The parts of a line of two points that none of others covers, as lengths along it.
std::vector<std::array<double, 2>> rest_of(const Stroke& stroke, const std::vector<std::array<Vec2, 2>>& others) {
  const Vec2& start = stroke.points.front();
  const double length = glm::distance(start, stroke.points.back());
  std::vector<std::array<double, 2>> covers;
  for (const auto& [from, to] : others) {
    const Vec2 along = (stroke.points.back() - start) / length, across(-along.y, along.x);
    const auto is_beside = [&](const Vec2& p) { return std::abs(glm::dot(p - start, across)) > on_dividing_line; };
    if (is_beside(from) || is_beside(to)) continue;
    const double one = glm::dot(from - start, along), other = glm::dot(to - start, along);
    const double low = std::min(one, other), high = std::max(one, other);
    if (high > 0 && low < length) covers.push_back({std::max(low, 0.0), std::min(high, length)});
  }
  std::sort(covers.begin(), covers.end());
  std::vector<std::array<double, 2>> rest;
  double covered = 0;
  for (const auto& [low, high] : covers) {
    if (low > covered) rest.push_back({covered, low});
    covered = std::max(covered, high);
  }
  if (covered < length) rest.push_back({covered, length});
  check(rest.empty() || (rest.front()[0] >= 0 && rest.back()[1] <= length), "what is left of a line lies on it");
  return rest;
}

void add_leg(Layer& layer, const Vec2& from, const Vec2& to, const LineWidths& widths) {
  Stroke chain{{from, to}};
  chain.dashes = fit_open(glm::distance(chain.points[0], chain.points[1]), widths.narrow, scene::long_dash_dot);
  layer.strokes.push_back(chain);
}

/// What a cutting-plane line consists of, as boxes.
struct PlaneMarks {
  std::vector<TurnedBox> arrows;  ///< and letters
  std::vector<TurnedBox> legs;    ///< of the line itself, with its wide ends
};

PlaneMarks marks_of(const Layer& line) {
  PlaneMarks marks;
  for (const Stroke& stroke : line.strokes)
    (stroke.dashes.dots > 0 ? marks.legs : marks.arrows).push_back(line_box(stroke.points[0], stroke.points[1]));
  for (const Fill& fill : line.fills) {
    check(!fill.rings.empty(), "arrows and wide ends have outlines");
    const std::vector<Vec2>& ring = fill.rings.front();
    Rectangle box{ring.front(), ring.front()};
    for (const Vec2& p : ring) box = united(box, {p, p});
    (ring.size() == 4 ? marks.legs : marks.arrows).push_back(turned_box(box));
  }
  for (const Text& letter : line.texts) {
    // Capitals are hardly wider than high.
    const Vec2 half = Vec2(static_cast<double>(letter.text.size()), 1) * letter.height / 2.0;
    const Vec2 middle = letter.at + Vec2(0, letter.height / 2);
    marks.arrows.push_back(turned_box({middle - half, middle + half}));
  }
  return marks;
}

// Lines may cross each other.
bool do_meet(const PlaneMarks& a, const PlaneMarks& b) {
  const auto any = [](const std::vector<TurnedBox>& some, const std::vector<TurnedBox>& others) {
    return std::any_of(some.begin(), some.end(), [&](const TurnedBox& box) {
      return std::any_of(others.begin(), others.end(), [&](const TurnedBox& other) { return overlap(box, other); });
    });
  };
  return any(a.arrows, b.arrows) || any(a.arrows, b.legs) || any(a.legs, b.arrows);
}

}  // namespace

bool sees_edge_on(const projection::Projection& projection, const cut::CuttingSurface& surface) {
  if (projection.central) return false;
  const Vec3 towards = glm::normalize(projection.projector);
  return std::abs(glm::dot(towards, surface.plane.normal)) <= seen_edge_on &&
         std::abs(glm::dot(towards, surface.along)) <= seen_edge_on;
}

Vec2 cutting_plane_room(const projection::Projection& projection, const cut::CuttingSurface& surface,
                        const LineWidths& widths) {
  const Vec3 p = projection.projector;
  const auto on_view = [&](const Vec3& v) {
    const Vec3 image = v - glm::dot(v, projection.n) / glm::dot(p, projection.n) * p;
    return glm::abs(glm::normalize(Vec2(glm::dot(image, projection.u), glm::dot(image, projection.v))));
  };
  const double height = letter_widths * widths.narrow;
  if (surface.aligned) {
    Vec2 most(0, 0);
    for (const cut::CutRegion* end : {&surface.regions.front(), &surface.regions.back()})
      most = glm::max(
          most, (past_ink + wide_end / 2 + letter_gap + 1) * height * on_view(along_trace(projection, *end->plane)) +
                    arrow_length * height * on_view(end->plane->normal));
    return most;
  }
  const Vec2 room =
      (past_ink + wide_end / 2 + letter_gap + 1) * height * on_view(along_trace(projection, surface.plane));
  if (surface.divides.empty()) return room;
  return room + (past_ink + wide_end + letter_gap + 1) * height * on_view(surface.plane.normal);
}

std::optional<Layer> cutting_plane_line(const drawing::ViewDrawing& parent, const cut::CuttingSurface& surface,
                                        const LineWidths& widths, double farther) {
  const double height = letter_widths * widths.narrow;
  const auto trace = trace_of(parent, surface, height, farther);
  if (!trace) return std::nullopt;
  check(trace->corners.size() == trace->legs.size() + 1, "a cutting plane goes from corner to corner");
  Layer layer = empty_layer(parent.name, scene::SheetLine::cutting_plane, widths);
  const std::size_t last = trace->corners.size() - 1;
  for (std::size_t leg = 0; leg < last; ++leg) {
    const Vec2 &a = trace->corners[leg], &b = trace->corners[leg + 1];
    const Vec2& along = trace->legs[leg];
    const double turn = std::min(wide_turn * height, glm::distance(a, b) / 2);
    const Vec2 from = a + (leg == 0 ? wide_end * height : turn) * along;
    const Vec2 to = b - (leg + 1 == last ? wide_end * height : turn) * along;
    if (glm::dot(to - from, along) > 0) add_leg(layer, from, to, widths);
  }
  for (std::size_t corner = 1; corner < last; ++corner) add_turn(layer, *trace, corner, widths, wide_turn * height);
  add_end(layer, trace->corners[0], -trace->legs[0], trace->seen[0], widths, surface.plane.name);
  add_end(layer, trace->corners[last], trace->legs[last - 1], trace->seen[1], widths, surface.plane.name);
  return layer;
}

std::vector<std::optional<Layer>> cutting_plane_lines(const drawing::ViewDrawing& parent,
                                                      std::span<const cut::CuttingSurface> surfaces,
                                                      const LineWidths& widths) {
  constexpr int max_rows = 6;
  // The arrows of the next row clear the letters of the one before.
  const double row = (letter_gap + 1 + letter_gap) * letter_widths * widths.narrow;
  std::vector<std::optional<Layer>> lines;
  std::vector<PlaneMarks> taken;
  for (const cut::CuttingSurface& surface : surfaces) {
    std::optional<Layer> line = cutting_plane_line(parent, surface, widths);
    const auto is_met = [&line](const PlaneMarks& other) { return line && do_meet(marks_of(*line), other); };
    for (int i = 1; i < max_rows && std::any_of(taken.begin(), taken.end(), is_met); ++i)
      line = cutting_plane_line(parent, surface, widths, i * row);
    if (line) taken.push_back(marks_of(*line));
    lines.push_back(std::move(line));
  }
  check(lines.size() == surfaces.size(), "every surface has a line or none");
  return lines;
}

void give_way(Layer& centre, const Layer& cutting_plane, const LineWidths& widths) {
  std::vector<std::array<Vec2, 2>> lines;
  for (const Stroke& leg : cutting_plane.strokes)
    if (leg.dashes.dots > 0) lines.push_back({leg.points.front(), leg.points.back()});
  for (const Fill& wide : cutting_plane.fills)
    if (const std::vector<Vec2>& box = wide.rings.front(); box.size() == 4)
      lines.push_back({(box[0] + box[1]) / 2.0, (box[2] + box[3]) / 2.0});
  std::vector<Stroke> remaining;
  for (Stroke& stroke : centre.strokes) {
    const bool is_straight = stroke.points.size() == 2 && stroke.points[0] != stroke.points[1];
    const std::vector<std::array<double, 2>> rest =
        is_straight ? rest_of(stroke, lines) : std::vector<std::array<double, 2>>();
    if (!is_straight ||
        (rest.size() == 1 && rest[0] == std::array{0.0, glm::distance(stroke.points[0], stroke.points[1])})) {
      remaining.push_back(std::move(stroke));
      continue;
    }
    const Vec2 from = stroke.points.front(), along = glm::normalize(stroke.points.back() - from);
    for (const auto& [begin, end] : rest)
      if (end - begin > shortest_rest) {
        Stroke piece{{from + begin * along, from + end * along}};
        piece.dashes = fit_open(end - begin, widths.narrow, scene::long_dash_dot);
        remaining.push_back(std::move(piece));
      }
  }
  centre.strokes = std::move(remaining);
}

void add_dividing_lines(Layer& centre, const drawing::ViewDrawing& view, const cut::CuttingSurface& surface,
                        const LineWidths& widths) {
  const Vec3 down = glm::cross(surface.along, surface.plane.normal);
  for (const Vec3& divide : surface.divides) {
    const Vec2 point = drawing::position_on_page(view, divide);
    const Vec2 image = Vec2(view.world_to_page * Vec4(down, 0));
    if (!(glm::length(image) > 0)) continue;
    const Vec2 along = glm::normalize(image), across(-along.y, along.x);
    LineExtent ink = extent_of(view, point, along);
    if (!(ink.from <= ink.to)) continue;
    ink = {ink.from - past_dividing, ink.to + past_dividing};
    std::erase_if(centre.strokes, [&](const Stroke& stroke) {
      return std::all_of(stroke.points.begin(), stroke.points.end(),
                         [&](const Vec2& p) { return std::abs(glm::dot(p - point, across)) < on_dividing_line; });
    });
    add_leg(centre, point + ink.from * along, point + ink.to * along, widths);
  }
}

}  // namespace epura::sheet
