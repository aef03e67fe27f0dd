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

// A line this near to a circle, in its radii, is of it: facets lie inside the circle, and so does the core of a thread
// whose nominal diameter is measured.
constexpr double of_circle = 0.2;
constexpr double by_facets = 0.05;       // the same of facets alone
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

bool has_line_along(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle, bool visible_only = false) {
  return std::any_of(drawing.segments.begin(), drawing.segments.end(), [&](const drawing::Segment& segment) {
    return (segment.visible || !visible_only) && is_along(in_circle(segment, circle), of_circle);
  });
}

bool has_line_at(const drawing::ViewDrawing& drawing, const Vec2& end, const MeasuredLength& length) {
  const double near = of_circle * glm::distance(length.from, length.to) / 2;
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

bool shows_circle(const drawing::ViewDrawing& drawing, const MeasuredDimension& measured) {
  if (const auto* circle = std::get_if<MeasuredCircle>(&measured.form)) return has_line_along(drawing, *circle);
  const auto* length = std::get_if<MeasuredLength>(&measured.form);
  check(length != nullptr, "a diameter is measured at a circle or along a line");
  return has_line_at(drawing, length->from, *length) || has_line_at(drawing, length->to, *length);
}

bool shows_visible(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle) {
  return has_line_along(drawing, circle, true);
}

DrawnParts::DrawnParts(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle) : circle_(circle) {
  holes_ = holes_on(circle, drawing);
  if (!holes_.empty()) return;
  const bool visible_only = has_line_along(drawing, circle, true);
  for (const drawing::Segment& segment : drawing.segments)
    if (const auto line = in_circle(segment, circle); (segment.visible || !visible_only) && is_along(line, by_facets))
      lines_.push_back(line);
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
  if (lines_.empty() || !circle_.is_whole()) return angles;
  const auto& [from, to] = *std::max_element(lines_.begin(), lines_.end(), [](const auto& a, const auto& b) {
    return glm::distance(a[0], a[1]) < glm::distance(b[0], b[1]);
  });
  const Vec2 middle = circle_.of_spokes((from + to) / 2.0);
  return {portable_atan2(middle.y, middle.x)};
}

}  // namespace epura::sheet
