// SPDX-License-Identifier: Apache-2.0
#include "dimensions/shown_circle.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

// A line this near to a circle, in its radii, is of it: facets lie inside the circle, and so does the core of a thread
// whose nominal diameter is measured.
constexpr double of_circle = 0.2;
constexpr double along_diameter = 1e-3;  // radians between a line and the diameter that it follows

Vec2 nearest_on(const drawing::Segment& segment, const Vec2& p) {
  const Vec2 along = segment.to - segment.from;
  const double length = glm::dot(along, along);
  return segment.from + (length > 0 ? std::clamp(glm::dot(p - segment.from, along) / length, 0.0, 1.0) : 0.0) * along;
}

bool has_line_along(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle, bool visible_only = false) {
  return std::any_of(drawing.segments.begin(), drawing.segments.end(), [&](const drawing::Segment& segment) {
    if (visible_only && !segment.visible) return false;
    const Vec2 from = circle.in_spokes(segment.from - circle.centre), to = circle.in_spokes(segment.to - circle.centre);
    const Vec2 along = to - from, spoke = (from + to) / 2.0;
    const bool is_on = std::abs(glm::length(spoke) - 1) <= of_circle;
    return is_on && std::abs(cross(along, spoke)) >= std::abs(glm::dot(along, spoke));
  });
}

bool has_line_at(const drawing::ViewDrawing& drawing, const Vec2& end, const MeasuredLength& length) {
  const double near = of_circle * glm::distance(length.from, length.to) / 2;
  return std::any_of(drawing.segments.begin(), drawing.segments.end(), [&](const drawing::Segment& segment) {
    const Vec2 along = segment.to - segment.from;
    return std::abs(cross(length.along, along)) > along_diameter * glm::length(along) &&
           glm::distance(nearest_on(segment, end), end) <= near;
  });
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

}  // namespace epura::sheet
