// SPDX-License-Identifier: Apache-2.0
#include "construction/axonometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/portable_math.hpp"
#include "base/text.hpp"

namespace epura::construction {

namespace {

using scene::ConstructionKind;

// Sizes of the figures, mm.
constexpr double arm = 24, cube = 26, triangle = 26;
constexpr double min_baseline = 17, beyond_arc = 1.5;
constexpr double min_radius = 6, usual_radius = 9, largest_radius = 18, between_arcs = 2.5;
constexpr double half_text = 2.65;  // of the height of an angle, with a gap
constexpr double caption_below = 8;
constexpr double seen_as_point = 1e-9;  // ratio of an axis along the projectors
constexpr std::array names{"x", "y", "z"};

std::string ratio_text(double ratio) { return format_rounded(ratio, 3); }

// From the nearer side of the horizontal line through the origin, 0 to 90 degrees, in radians.
double angle_of(const Vec2& image) { return portable_atan2(std::abs(image.y), std::abs(image.x)); }

// Neither horizontal nor upright.
bool is_oblique(const Vec2& image) {
  constexpr double least = 0.01 * std::numbers::pi / 180;
  return angle_of(image) >= least && angle_of(image) <= std::numbers::pi / 2 - least;
}

// Of an axis in the picture, the tip.
Vec2 arm_along(const Vec2& image) {
  const double ratio = glm::length(image);
  return image * (arm / std::max(ratio, 0.5) * std::min(ratio, 1.0));
}

/// The angle of an axis to the horizontal, in the figure.
struct AxisAngle {
  Vec2 tip;
  double radius = 0;  ///< of its arc
};

// Where the number has room between the legs if possible, and not beyond the tip. Of angles in one corner, the greater
// has the smaller arc, so that each number stands outside its arc and inside no smaller angle; it comes first.
std::vector<AxisAngle> angles_between(const std::array<Vec2, 3>& images) {
  std::vector<AxisAngle> angles;
  for (const Vec2& image : images)
    if (glm::length(image) > seen_as_point && is_oblique(image)) angles.push_back({arm_along(image)});
  std::stable_sort(angles.begin(), angles.end(),
                   [](const AxisAngle& a, const AxisAngle& b) { return angle_of(a.tip) < angle_of(b.tip); });
  for (std::size_t i = 0; i < angles.size(); ++i) {
    AxisAngle& one = angles[i];
    one.radius = std::max(half_text / portable_tan(angle_of(one.tip) / 2) - 1, usual_radius);
    one.radius = std::min({one.radius, glm::length(one.tip) - beyond_arc, largest_radius});
    for (std::size_t j = 0; j < i; ++j)
      if ((angles[j].tip.x > 0) == (one.tip.x > 0) && (angles[j].tip.y > 0) == (one.tip.y > 0))
        one.radius = std::min(one.radius, angles[j].radius - between_arcs);
    one.radius = std::max(one.radius, min_radius);
  }
  std::reverse(angles.begin(), angles.end());
  return angles;
}

// With an arc each, and one base line on each side.
void add_angles(Figure& key, const std::array<Vec2, 3>& images) {
  std::array<double, 2> baselines{0, 0};  // on the left, on the right
  for (const AxisAngle& angle : angles_between(images)) {
    const double from = angle.tip.x > 0 ? 0 : std::numbers::pi;
    const double to = std::remainder(portable_atan2(angle.tip.y, angle.tip.x) - from, 2 * std::numbers::pi) + from;
    const std::string degrees = format_rounded(angle_of(angle.tip) * 180 / std::numbers::pi, 3) + "°";
    key.curves.push_back(
        {{0, 0}, {angle.radius, 0}, {0, angle.radius}, std::min(from, to), std::max(from, to), {degrees}});
    const double reach = angle.radius + beyond_arc;
    if (reach > glm::length(angle.tip)) key.lines.push_back({angle.tip, glm::normalize(angle.tip) * reach});
    double& baseline = baselines[angle.tip.x > 0 ? 1 : 0];
    baseline = std::max({baseline, min_baseline, reach});
  }
  if (baselines[0] > 0) key.lines.push_back({{0, 0}, {-baselines[0], 0}});
  if (baselines[1] > 0) key.lines.push_back({{0, 0}, {baselines[1], 0}});
}

bool is_orthographic(const PicturePlane& plane) {
  return glm::length(glm::cross(glm::normalize(plane.projector), plane.n)) <= 1e-9;
}

Figure axes_figure(const PicturePlane& plane, const std::array<Vec2, 3>& images) {
  Figure key;
  double lowest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double ratio = glm::length(images[i]);
    if (ratio <= seen_as_point) {
      key.points.push_back({{names[i]}, {0, 0}, {0, 0}, true, true});
      continue;
    }
    const Vec2 tip = arm_along(images[i]);
    lowest = std::min(lowest, tip.y);
    key.lines.push_back({{0, 0}, tip});
    key.points.push_back({{std::string(names[i]) + " " + ratio_text(ratio)}, tip, {0, 0}, false, true});
  }
  add_angles(key, images);
  if (!is_orthographic(plane)) {
    const double slope = std::asin(glm::dot(glm::normalize(plane.projector), plane.n)) * 180 / std::numbers::pi;
    const Vec2 below(0, lowest - caption_below);
    key.points.push_back({{"projectors " + format_rounded(slope, 3) + "° to the picture"}, below, below, false, true});
  }
  return key;
}

// The cube and the circles on those of its faces that the viewer sees.
Figure ellipses_figure(const PicturePlane& plane, const std::array<Vec2, 3>& images) {
  Figure key;
  std::array<Vec2, 3> side{};  // from the nearest corner along the edges
  std::array<bool, 3> is_seen{};
  for (int i = 0; i < 3; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const double towards = glm::normalize(plane.projector)[i];
    is_seen[a] = std::abs(towards) > seen_as_point;
    side[a] = images[a] * (towards > 0 ? -cube : cube);
  }
  const Vec2 nearest = -(side[0] + side[1] + side[2]) / 2.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_seen[i]) continue;
    const Vec2 &p = side[(i + 1) % 3], &q = side[(i + 2) % 3];
    key.lines.push_back({nearest + p, nearest + p + q});
    key.lines.push_back({nearest + q, nearest + p + q});
    Curve ellipse = ellipse_of(nearest + (p + q) / 2.0, p / 2.0, q / 2.0);
    const double major = glm::length(ellipse.u) / (cube / 2), minor = glm::length(ellipse.v) / (cube / 2);
    key.points.push_back({{ratio_text(major) + ":" + ratio_text(minor)}, ellipse.centre, ellipse.centre, false, true});
    key.curves.push_back(std::move(ellipse));
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (is_seen[(i + 1) % 3] || is_seen[(i + 2) % 3]) key.lines.push_back({nearest, nearest + side[i]});
  return key;
}

// The axes meet the picture at distances t from a point behind it, where t (a.n) is the same for all.
Figure trace_figure(const PicturePlane& plane, const std::array<Vec2, 3>& images, const Request& request) {
  Figure key;
  std::array<Vec2, 3> traces{};
  double farthest = 0;
  for (int i = 0; i < 3; ++i) {
    const auto a = static_cast<std::size_t>(i);
    if (std::abs(plane.n[i]) <= 1e-12) {
      if (request.optional) return key;
      refuse(request, std::string("has no triangle: the axis ") + names[a] + " is parallel to the picture",
             "choose a projection whose plane cuts all three axes, such as isometric");
    }
    traces[a] = images[a] / plane.n[i];
    farthest = std::max(farthest, glm::length(traces[a]));
  }
  for (Vec2& trace : traces) trace *= triangle / farthest;
  key.points.push_back({{"O"}, {0, 0}, {0, 0}, true, true});
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &a = traces[(i + 1) % 3], &b = traces[(i + 2) % 3];
    key.lines.push_back({a, b});
    // In orthographic views, the axis is perpendicular to the opposite side, up to which it is drawn.
    Vec2 foot(0, 0);
    if (is_orthographic(plane)) foot = a + (b - a) * (glm::dot(-a, b - a) / glm::dot(b - a, b - a));
    key.lines.push_back({foot, traces[i]});
    key.points.push_back({{"T", names[i]}, traces[i], {0, 0}, true, true});
  }
  return key;
}

}  // namespace

Figure axonometry_figure(const PicturePlane& plane, double factor, std::span<const Request> requests) {
  const std::array<Vec2, 3> images = axis_images(plane, factor);
  Figure figure;
  const auto add = [&figure](Figure key) {
    if (!key.empty()) figure.keys.push_back(std::move(key));
  };
  for (const Request& request : requests) {
    if (request.item.kind == ConstructionKind::axes) {
      add(axes_figure(plane, images));
      add_term(figure, "x y z", "axes: ratios, angles to the horizontal");
    }
    if (request.item.kind == ConstructionKind::ellipses) {
      add(ellipses_figure(plane, images));
      add_term(figure, "a:b", "axes of the ellipse of a circle, diameter 1");
    }
    if (request.item.kind == ConstructionKind::trace_triangle) {
      add(trace_figure(plane, images, request));
      add_term(figure, "T", "traces of the axes through O in the picture");
    }
  }
  return figure;
}

}  // namespace epura::construction
