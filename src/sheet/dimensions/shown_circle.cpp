// SPDX-License-Identifier: Apache-2.0
#include "dimensions/shown_circle.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

namespace {

constexpr double of_face = 0.01;         // of its radius: ends of an edge on a face of the circle are no farther off
constexpr double by_facets = 0.05;       // the same of what lies on facets, which are inside
constexpr double of_outline = 0.2;       // the same of outlines of coarse facets, and of roots of threads
constexpr double along_diameter = 1e-3;  // radians between a line and the diameter that it follows

// Seen from the centre, in lengths of the spokes.
std::array<Vec2, 2> in_circle(const drawing::Segment& segment, const MeasuredCircle& circle) {
  return {circle.in_spokes(segment.from - circle.centre), circle.in_spokes(segment.to - circle.centre)};
}

// Whether a line is a chord of the circle: both ends are beside it, unlike those of an edge that only passes.
bool is_along(const std::array<Vec2, 2>& line, double off) {
  const Vec2 along = line[1] - line[0], spoke = (line[0] + line[1]) / 2.0;
  const auto is_beside = [&](const Vec2& place) { return std::abs(glm::length(place) - 1) <= off; };
  return is_beside(line[0]) && is_beside(spoke) && is_beside(line[1]) &&
         std::abs(cross(along, spoke)) >= std::abs(glm::dot(along, spoke));
}

// Whether a part of a line is beside the arc.
bool is_on_arc(const std::array<Vec2, 2>& line, const MeasuredCircle& circle) {
  if (circle.is_whole()) return true;
  const auto angle_of = [&circle](const Vec2& p) {
    const Vec2 spoke = circle.of_spokes(p);
    return portable_atan2(spoke.y, spoke.x);
  };
  const double span = std::abs(std::remainder(angle_of(line[1]) - angle_of(line[0]), full_turn));
  const double middle = angle_of((line[0] + line[1]) / 2.0) - circle.first - circle.sweep / 2;
  return std::abs(std::remainder(middle, full_turn)) <= (std::abs(circle.sweep) + span) / 2;
}

// Whether a line lies on the face around the axis of a circle; one that is no edge of a file ends amid facets.
bool is_on_face(const drawing::Segment& segment, const drawing::ViewDrawing& drawing, const MeasuredCircle& circle,
                const world::World& world) {
  const double radius = circle.is_radius ? circle.value : circle.value / 2;
  const auto is_near = [&](const Vec3& p, double inside) {
    const double off = glm::length(glm::cross(p - circle.place, circle.axis)) / radius - 1;
    return off >= -inside && off <= of_face;
  };
  if (segment.crossing >= 0) {
    const auto& ends = drawing.crossings[static_cast<std::size_t>(segment.crossing)].world;
    return is_near(ends[0], by_facets) && is_near(ends[1], by_facets);
  }
  const auto first =
      static_cast<std::size_t>(world.first_vertex[static_cast<std::size_t>(drawing.number_in_scene(segment.model))]);
  return std::ranges::all_of(segment.edge, [&](int vertex) {
    return is_near(world.points[first + static_cast<std::size_t>(vertex)], of_face);
  });
}

bool has_line_at(const drawing::ViewDrawing& drawing, const Vec2& end, const MeasuredLength& length) {
  const double near = of_outline * glm::distance(length.from, length.to) / 2;
  return std::any_of(drawing.segments.begin(), drawing.segments.end(), [&](const drawing::Segment& segment) {
    const Vec2 along = segment.to - segment.from;
    return std::abs(cross(length.along, along)) > along_diameter * glm::length(along) &&
           glm::distance(nearest_on_segment(end, segment.from, segment.to), end) <= near;
  });
}

// Round lines around points of a circle that is not drawn itself: of holes, if there are several.
std::vector<Disc> holes_on(const MeasuredCircle& circle, const drawing::ViewDrawing& drawing) {
  if (circle.spokes || !circle.is_whole()) return {};
  std::vector<Disc> discs = discs_of(drawing);
  const auto off = [&circle](const Disc& disc) { return glm::distance(disc.centre, circle.centre); };
  const bool is_drawn = std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
    return off(disc) <= on_line && std::abs(disc.radius - circle.radius) <= by_facets * circle.radius;
  });
  std::erase_if(discs, [&](const Disc& disc) { return std::abs(off(disc) - circle.radius) > on_line; });
  return is_drawn || discs.size() < 2 ? std::vector<Disc>() : discs;
}

}  // namespace

std::vector<LineOfCircle> lines_along(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle,
                                      const world::World* world) {
  std::vector<LineOfCircle> lines;
  const auto add_within = [&](double off, bool only_outlines) {
    for (const drawing::Segment& segment : drawing.segments) {
      const auto line = in_circle(segment, circle);
      // As of balls and rounded edges, which have a radius and are seen as circles: edges beside them are none of
      // theirs. Roots of threads are drawn beside the core that the model has.
      const bool is_outline =
          segment.kind == EdgeKind::thread || (segment.kind == EdgeKind::contour && circle.is_radius && !circle.spokes);
      if ((is_outline || !only_outlines) && is_along(line, off) && is_on_arc(line, circle) &&
          (is_outline || world == nullptr || is_on_face(segment, drawing, circle, *world)))
        lines.push_back({line, segment.visible});
    }
  };
  add_within(by_facets, false);
  if (lines.empty()) add_within(of_outline, true);
  check(lines.size() <= drawing.segments.size(), "lines of a circle are lines of its view");
  return lines;
}

bool shows_circle(const drawing::ViewDrawing& drawing, const MeasuredDimension& measured) {
  if (const auto* circle = std::get_if<MeasuredCircle>(&measured.form))
    return !circle->lines.empty() || !holes_on(*circle, drawing).empty();
  const auto* length = std::get_if<MeasuredLength>(&measured.form);
  check(length != nullptr, "a diameter is measured at a circle or along a line");
  return has_line_at(drawing, length->from, *length) || has_line_at(drawing, length->to, *length);
}

bool shows_visible(const MeasuredCircle& circle) { return std::ranges::any_of(circle.lines, &LineOfCircle::visible); }

DrawnParts::DrawnParts(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle) : circle_(circle) {
  holes_ = holes_on(circle, drawing);
  if (!holes_.empty()) return;
  const bool visible_only = shows_visible(circle);
  for (const LineOfCircle& line : circle.lines)
    if (line.visible || !visible_only) lines_.push_back(line.ends);
}

bool DrawnParts::is_at(double angle) const {
  const Vec2 tip = circle_.centre + circle_.reach(turned_to(angle)) * turned_to(angle);
  if (!holes_.empty())
    return std::none_of(holes_.begin(), holes_.end(),
                        [&tip](const Disc& hole) { return glm::distance(tip, hole.centre) <= hole.radius; });
  const Vec2 p = circle_.in_spokes(turned_to(angle));
  return std::any_of(lines_.begin(), lines_.end(), [&p](const std::array<Vec2, 2>& line) {
    return cross(line[0], p) * cross(p, line[1]) >= 0 && glm::dot(line[0] + line[1], p) > 0;
  });
}

std::vector<double> DrawnParts::among(const std::vector<double>& angles) const {
  std::vector<double> drawn;
  std::copy_if(angles.begin(), angles.end(), std::back_inserter(drawn), [this](double angle) { return is_at(angle); });
  check(drawn.size() <= angles.size(), "a leader has one of the directions that it may have");
  if (!drawn.empty()) return drawn;
  if (lines_.empty()) return angles;
  const auto& [from, to] = *std::max_element(lines_.begin(), lines_.end(), [](const auto& a, const auto& b) {
    return glm::distance(a[0], a[1]) < glm::distance(b[0], b[1]);
  });
  const Vec2 middle = circle_.of_spokes((from + to) / 2.0);
  return {portable_atan2(middle.y, middle.x)};
}

}  // namespace epura::sheet
