// SPDX-License-Identifier: Apache-2.0
#include "output/dxf_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/circle_fit.hpp"
#include "base/curve_runs.hpp"

namespace epura::output {

namespace {

constexpr double slack = 1e-9;  // for computed angles and ratios

bool is_circle(const drawing::CurvePart& curve) {
  const double u = glm::length(curve.u), v = glm::length(curve.v);
  return std::abs(u - v) <= slack * std::max(u, v);
}

Vec2 point_at(const drawing::CurvePart& curve, double angle) {
  return curve.centre + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
}

// Normalised: v to the left of u, u the longer half axis, and increasing angles.
EllipseArc arc_of(drawing::CurvePart curve) {
  if (cross(curve.u, curve.v) < 0) {
    curve.v = -curve.v;
    curve.from = -curve.from;
    curve.to = -curve.to;
  }
  if (glm::length(curve.v) > glm::length(curve.u) && !is_circle(curve)) {
    curve.u = std::exchange(curve.v, -curve.u);
    curve.from -= full_turn / 4;
    curve.to -= full_turn / 4;
  }
  if (curve.to < curve.from) std::swap(curve.from, curve.to);
  const double ratio = is_circle(curve) ? 1 : glm::length(curve.v) / glm::length(curve.u);
  return {curve.centre, curve.u, ratio, curve.from, curve.to};
}

// Arcs of at most a quarter turn: bulges grow without bounds towards a full turn.
void add_bulges(BulgedLine& line, const Vec2& start, const drawing::CurvePart& curve) {
  const double sweep = cross(curve.u, curve.v) < 0 ? curve.from - curve.to : curve.to - curve.from;
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (full_turn / 4) - slack)));
  const double bulge = std::tan(sweep / pieces / 4);
  for (int i = 0; i < pieces; ++i)
    line.corners.push_back(
        {i == 0 ? start : point_at(curve, curve.from + (curve.to - curve.from) * i / pieces), bulge});
}

void add_line(std::vector<DxfShape>& shapes, BulgedLine& line) {
  if (line.corners.size() > 1) shapes.emplace_back(std::move(line));
  line = {};
}

constexpr double fits = 0.01, bends = 0.05;  // mm: of corners, and of the middles of pieces, from the arc

struct StrokeArc {
  Vec2 centre;
  double radius, sweep, deviation, tolerance;
};

// The arc through consecutive corners of a stroke whose pieces differ little from it, and which turn in one direction.
std::optional<StrokeArc> arc_through(const std::vector<Vec2>& corners) {
  const std::optional<FittedCircle> circle = fit_circle(corners);
  if (!circle || circle->deviation > fits) return std::nullopt;
  double sweep = 0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Vec2 a = corners[i] - circle->centre, b = corners[i + 1] - circle->centre;
    const double turn = std::atan2(cross(a, b), glm::dot(a, b));
    if (turn == 0 || turn * sweep < 0 || circle->radius * (1 - std::cos(turn / 2)) > bends) return std::nullopt;
    sweep += turn;
  }
  return StrokeArc{circle->centre, circle->radius, sweep, circle->deviation, fits};
}

}  // namespace

sheet::Stroke with_arcs(sheet::Stroke stroke) {
  constexpr int min_pieces = 4;
  const int count = static_cast<int>(stroke.points.size());
  if (!stroke.curves.empty() || count <= min_pieces) return stroke;
  const auto point = [&](int i) { return stroke.points[static_cast<std::size_t>((i % count + count) % count)]; };
  const auto window = [](int first, int most) { return std::min(first + min_pieces, most); };
  const auto fit = [&](int first, int last) -> std::optional<StrokeArc> {
    if (last - first < min_pieces || last - first > count) return std::nullopt;
    std::vector<Vec2> corners;
    for (int i = first; i <= last; ++i) corners.push_back(point(i));
    return arc_through(corners);
  };
  for (const CurveRun<StrokeArc>& run : find_curve_runs<StrokeArc>(count, stroke.closed, window, fit)) {
    const Vec2 from = point(run.first) - run.curve.centre;
    const double begin = std::atan2(from.y, from.x), radius = run.curve.radius;
    stroke.curves.push_back(
        {run.first, run.last, run.curve.centre, {radius, 0}, {0, radius}, begin, begin + run.curve.sweep});
  }
  return stroke;
}

bool EllipseArc::whole() const { return to - from >= full_turn - slack; }

namespace {

/// Collects the shapes of one stroke.
class ShapesOfStroke {
 public:
  explicit ShapesOfStroke(DxfArcs arcs) : arcs_(arcs) {}

  void add_point(const Vec2& point) { line_.corners.push_back({point}); }
  /// A part of the stroke from one of its points to another.
  void add_curve(const Vec2& from, const Vec2& to, const drawing::CurvePart& curve) {
    if (arcs_ == DxfArcs::bulges && is_circle(curve)) return add_bulges(line_, from, curve);
    add_point(from);
    if (arcs_ == DxfArcs::entities && !is_circle(curve)) return add_chords(curve);
    add_line(shapes_, line_);
    if (arcs_ == DxfArcs::bulges) return void(shapes_.emplace_back(arc_of(curve)));
    add_arcs(from, to, curve);
  }
  std::vector<DxfShape> finish(bool closed, const Vec2& end) {
    line_.closed = closed && shapes_.empty();
    if (!line_.closed) add_point(end);
    add_line(shapes_, line_);
    return std::move(shapes_);
  }

 private:
  // The corners between the ends of an elliptical arc.
  void add_chords(const drawing::CurvePart& curve) {
    constexpr double sagitta = 0.001;  // mm
    const double longest = std::max(glm::length(curve.u), glm::length(curve.v));
    const double step = 2 * std::acos(1 - std::min(sagitta / longest, 0.5));
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(curve.to - curve.from) / step)));
    for (int i = 1; i < pieces; ++i) add_point(point_at(curve, curve.from + (curve.to - curve.from) * i / pieces));
  }

  // Points of a stroke lie near its arcs, not on them: each arc is the one of the same angle through its two points. Up
  // to half a turn, that moves it by no more than they are off.
  void add_arcs(const Vec2& from, const Vec2& to, const drawing::CurvePart& curve) {
    const double sweep = cross(curve.u, curve.v) < 0 ? curve.from - curve.to : curve.to - curve.from;
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (full_turn / 2) - slack)));
    Vec2 begin = from;
    for (int i = 1; i <= pieces; ++i) {
      const Vec2 end = i == pieces ? to : point_at(curve, curve.from + (curve.to - curve.from) * i / pieces);
      const Vec2 half = (end - begin) * 0.5;
      const Vec2 centre = begin + half + Vec2(-half.y, half.x) / std::tan(sweep / pieces / 2);
      const Vec2 first = (sweep > 0 ? begin : end) - centre, last = (sweep > 0 ? end : begin) - centre;
      const double start = std::atan2(first.y, first.x);
      double turn = std::atan2(last.y, last.x) - start;
      if (turn < 0) turn += full_turn;
      shapes_.emplace_back(
          EllipseArc{centre, {(glm::length(first) + glm::length(last)) / 2, 0}, 1, start, start + turn});
      begin = end;
    }
  }

  DxfArcs arcs_;
  std::vector<DxfShape> shapes_{};
  BulgedLine line_{};
};

}  // namespace

std::vector<DxfShape> dxf_shapes(const sheet::Stroke& stroke, DxfArcs arcs) {
  const int count = static_cast<int>(stroke.points.size());
  const auto point = [&](int i) { return stroke.points[static_cast<std::size_t>(i % count)]; };
  const auto& curves = stroke.curves;
  const int start = stroke.closed && !curves.empty() ? curves.front().first : 0;
  const int end = stroke.closed ? start + count : count - 1;
  const bool is_one_curve = curves.size() == 1 && curves[0].first == start && curves[0].last == end;
  const bool is_ring = is_one_curve && stroke.closed && is_circle(curves[0]);
  if (is_ring || (is_one_curve && arcs == DxfArcs::bulges)) return {arc_of(curves[0])};

  ShapesOfStroke shapes(arcs);
  int here = start;
  for (const drawing::CurvePart& curve : curves) {
    for (; here < curve.first; ++here) shapes.add_point(point(here));
    shapes.add_curve(point(here), point(curve.last), curve);
    here = curve.last;
  }
  for (; here < end; ++here) shapes.add_point(point(here));
  return shapes.finish(stroke.closed, point(end));
}

}  // namespace epura::output
