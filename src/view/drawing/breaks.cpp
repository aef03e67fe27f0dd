// SPDX-License-Identifier: Apache-2.0
#include "drawing/breaks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "drawing/boundary.hpp"
#include "drawing/chains.hpp"
#include "drawing/clip_drawing.hpp"
#include "drawing/closed_line.hpp"
#include "drawing/drawing.hpp"
#include "drawing/freehand.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

struct Interval {
  double min, max, shift;
};

double moved_along(const std::vector<LeftOut>& strips, double gap, double x) {
  double shift = 0;
  for (const LeftOut& strip : strips) {
    if (x <= strip.from) break;
    if (std::isinf(strip.to)) return strip.from + shift;
    if (std::isinf(strip.from)) {
      if (x < strip.to) return strip.to;
      continue;
    }
    const double length = strip.to - strip.from;
    if (x < strip.to) return strip.from + shift + gap * (x - strip.from) / length;
    shift += gap - length;
  }
  return x + shift;
}

std::vector<Interval> kept_along(const std::vector<LeftOut>& strips, double gap) {
  std::vector<Interval> kept;
  double begin = -HUGE_VAL, shift = 0;
  for (const LeftOut& strip : strips) {
    check(strip.from >= begin && strip.to >= strip.from, "strips that are left out are in order");
    if (!std::isinf(strip.from)) kept.push_back({begin, strip.from, shift});
    if (strip.is_between()) shift += gap - (strip.to - strip.from);
    begin = strip.to;
  }
  if (!std::isinf(begin) || begin < 0) kept.push_back({begin, HUGE_VAL, shift});
  return kept;
}

// A finite rectangle with everything of a part that is drawn.
Boundary boundary_of(const KeptPart& part, const ViewDrawing& drawing) {
  const Vec2 min = glm::max(part.min, drawing.box.min - 1.0), max = glm::min(part.max, drawing.box.max + 1.0);
  return {(min + max) / 2.0, glm::max((max - min) / 2.0, Vec2(0)), false};
}

std::optional<std::array<double, 2>> inside_part(const KeptPart& part, const Vec2& from, const Vec2& to) {
  const Vec2 min = glm::max(part.min, glm::min(from, to)), max = glm::min(part.max, glm::max(from, to));
  if (min.x > max.x || min.y > max.y) return std::nullopt;
  return part_inside({(min + max) / 2.0, (max - min) / 2.0, false}, from, to);
}

// Of a convex polygon: what is on one side of a line perpendicular to an axis.
std::vector<Vec2> cut_off(const std::vector<Vec2>& polygon, int axis, double at, double side) {
  std::vector<Vec2> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = side * (p[axis] - at), b = side * (q[axis] - at);
    if (a >= 0) rest.push_back(p);
    if ((a < 0) != (b < 0)) rest.push_back(p + a / (a - b) * (q - p));
  }
  return rest;
}

void add_part(std::vector<PaperTriangle>& triangles, const PaperTriangle& whole, const KeptPart& part) {
  std::vector<Vec2> polygon(whole.begin(), whole.end());
  for (const int axis : {0, 1}) {
    if (!std::isinf(part.min[axis])) polygon = cut_off(polygon, axis, part.min[axis], 1);
    if (!std::isinf(part.max[axis])) polygon = cut_off(polygon, axis, part.max[axis], -1);
  }
  for (std::size_t i = 2; i < polygon.size(); ++i)
    triangles.push_back({polygon[0] + part.shift, polygon[i - 1] + part.shift, polygon[i] + part.shift});
}

// The extent of the visible ink of a part along a line that limits it. Ink that only ends there counts, too.
std::optional<std::array<double, 2>> extent_at(const ViewDrawing& drawing, int axis, double at, const KeptPart& part) {
  const int across = 1 - axis;
  std::array<double, 2> extent{HUGE_VAL, -HUGE_VAL};
  const auto add = [&](double y) {
    if (y < part.min[across] - rounding_mm || y > part.max[across] + rounding_mm) return;
    extent = {std::min(extent[0], y), std::max(extent[1], y)};
  };
  for (const Segment& segment : drawing.segments) {
    if (!segment.visible) continue;
    const Vec2 &p = segment.from, &q = segment.to;
    if (std::abs(p[axis] - at) <= rounding_mm) add(p[across]);
    if (std::abs(q[axis] - at) <= rounding_mm) add(q[across]);
    if ((p[axis] < at) != (q[axis] < at))
      add(p[across] + (at - p[axis]) / (q[axis] - p[axis]) * (q[across] - p[across]));
  }
  return extent[0] < extent[1] ? std::optional(extent) : std::nullopt;
}

bool is_symmetric(const Breaks& breaks, int axis, double at) {
  return std::any_of(breaks.along[axis].begin(), breaks.along[axis].end(),
                     [&](const LeftOut& strip) { return strip.symmetric && (strip.from == at || strip.to == at); });
}

bool is_freehand(const Breaks& breaks, int axis, double at) {
  return breaks.freehand && !std::isinf(at) && !is_symmetric(breaks, axis, at);
}

std::vector<Limit> straight_limits(const ViewDrawing& drawing, const Breaks& breaks) {
  std::vector<Limit> limits;
  for (const KeptPart& part : kept_parts(breaks))
    for (const int axis : {0, 1})
      for (const double at : {part.min[axis], part.max[axis]}) {
        if (std::isinf(at) || is_freehand(breaks, axis, at)) continue;
        const auto extent = extent_at(drawing, axis, at, part);
        if (!extent) continue;
        Limit limit{part.shift, part.shift, is_symmetric(breaks, axis, at)};
        limit.from[axis] += at;
        limit.to[axis] += at;
        const int across = 1 - axis;
        const std::optional<double> other = breaks.mirror(across);
        limit.meets = {other && *other == part.min[across], other && *other == part.max[across]};
        limit.from[across] += limit.meets[0] ? part.min[across] : (*extent)[0];
        limit.to[across] += limit.meets[1] ? part.max[across] : (*extent)[1];
        check(limit.from[across] <= limit.to[across] + 2 * rounding_mm, "a limit goes forwards");
        limits.push_back(limit);
      }
  return limits;
}

// The line around a part that has freehand lines perpendicular to one axis.
ClosedLine line_around(const KeptPart& part, const Breaks& breaks, int axis, const ViewDrawing& drawing) {
  const int across = 1 - axis;
  const Boundary box = boundary_of(part, drawing);
  const auto side = [&](double at, double place, double from, double to) {
    Vec2 begin, end;
    begin[axis] = end[axis] = place;
    begin[across] = from;
    end[across] = to;
    return is_freehand(breaks, axis, at) ? freehand_along(across, begin, end) : std::vector{begin, end};
  };
  const Vec2 min = box.centre - box.half, max = box.centre + box.half;
  std::vector<Vec2> corners = side(part.min[axis], min[axis], min[across], max[across]);
  const std::vector<Vec2> back = side(part.max[axis], max[axis], max[across], min[across]);
  corners.insert(corners.end(), back.begin(), back.end());
  return ClosedLine(std::move(corners));
}

// The freehand lines of a part between the outermost visible lines that end at them.
void add_freehand_limits(std::vector<Limit>& limits, const ViewDrawing& drawing, const Breaks& breaks, int axis,
                         const KeptPart& part) {
  const int across = 1 - axis;
  for (const double at : {part.min[axis], part.max[axis]}) {
    if (!is_freehand(breaks, axis, at)) continue;
    std::array<double, 2> extent{HUGE_VAL, -HUGE_VAL};
    for (const Segment& segment : drawing.segments)
      for (const Vec2& p : {segment.from, segment.to})
        if (segment.visible && std::abs(p[axis] - at - freehand_offset(p[across])) <= on_freehand)
          extent = {std::min(extent[0], p[across]), std::max(extent[1], p[across])};
    if (!(extent[0] < extent[1])) continue;
    Limit limit{part.shift, part.shift, false};
    const std::optional<double> mirror = breaks.mirror(across);
    limit.meets = {mirror && *mirror == part.min[across], mirror && *mirror == part.max[across]};
    limit.from[axis] = limit.to[axis] = at;
    limit.from[across] = limit.meets[0] ? part.min[across] : extent[0];
    limit.to[across] = limit.meets[1] ? part.max[across] : extent[1];
    for (const Vec2& p : freehand_along(across, limit.from, limit.to)) limit.freehand.push_back(p + part.shift);
    check(limit.freehand.size() >= 2, "a freehand line has two ends");
    limit.from += part.shift;
    limit.to += part.shift;
    limits.push_back(std::move(limit));
  }
}

void clip_to_part(ViewDrawing& drawing, const ViewDrawing& whole, const KeptPart& part, const Breaks& breaks,
                  std::vector<Limit>& limits) {
  for (const int axis : {0, 1}) {
    if (!is_freehand(breaks, axis, part.min[axis]) && !is_freehand(breaks, axis, part.max[axis])) continue;
    clip_to(drawing, line_around(part, breaks, axis, whole));
    return add_freehand_limits(limits, drawing, breaks, axis, part);
  }
  clip_to(drawing, boundary_of(part, whole));
}

// A view cut to one part, and moved.
ViewDrawing part_of(const ViewDrawing& whole, const KeptPart& part, const Breaks& breaks, std::vector<Limit>& limits) {
  ViewDrawing drawing;
  drawing.segments = whole.segments;
  drawing.crossings = whole.crossings;
  drawing.cuts.faces = whole.cuts.faces;
  drawing.cuts.broken_out = whole.cuts.broken_out;
  clip_to_part(drawing, whole, part, breaks, limits);
  for (Segment& segment : drawing.segments) {
    segment.from += part.shift;
    segment.to += part.shift;
  }
  for (CutFace& face : drawing.cuts.faces)
    for (std::vector<Vec2>& ring : face.rings)
      for (Vec2& p : ring) p += part.shift;
  for (BrokenOut& broken_out : drawing.cuts.broken_out)
    for (std::vector<Vec2>& line : broken_out.lines)
      for (Vec2& p : line) p += part.shift;
  return drawing;
}

}  // namespace

bool LeftOut::is_between() const { return !std::isinf(from) && !std::isinf(to); }

bool Breaks::keeps(const Vec2& p) const {
  for (const int axis : {0, 1})
    for (const LeftOut& strip : along[axis])
      if (p[axis] > strip.from + on_line_mm && p[axis] < strip.to - on_line_mm) return false;
  return true;
}

Vec2 Breaks::moved(const Vec2& p) const { return {moved_along(along[0], gap, p.x), moved_along(along[1], gap, p.y)}; }

Vec2 Breaks::restored(const Vec2& p) const {
  Vec2 whole = p;
  for (const int axis : {0, 1})
    for (const Interval& kept : kept_along(along[axis], gap))
      if (p[axis] >= kept.min + kept.shift - rounding_mm) whole[axis] = p[axis] - kept.shift;
  return whole;
}

std::optional<double> Breaks::mirror(int axis) const {
  for (const LeftOut& strip : along[axis])
    if (strip.symmetric) return std::isinf(strip.from) ? strip.to : strip.from;
  return std::nullopt;
}

bool Breaks::are_mirrored(const Vec2& p, const Vec2& q, int axis, double slack) const {
  const std::optional<double> at = mirror(axis);
  return at && keeps(p) != keeps(q) && std::abs(p[axis] + q[axis] - 2 * *at) <= slack &&
         std::abs(p[axis] - q[axis]) > slack;
}

double Breaks::gaps(int axis) const {
  return gap * static_cast<double>(std::count_if(along[axis].begin(), along[axis].end(),
                                                 [](const LeftOut& strip) { return strip.is_between(); }));
}

Breaks mapped(const Breaks& breaks, double scale, const Vec2& shift, double gap) {
  Breaks result = breaks;
  for (const int axis : {0, 1})
    for (LeftOut& strip : result.along[axis]) {
      strip.from = scale * strip.from + shift[axis];
      strip.to = scale * strip.to + shift[axis];
    }
  result.gap = gap;
  return result;
}

std::vector<KeptPart> kept_parts(const Breaks& breaks) {
  std::vector<KeptPart> parts;
  for (const Interval& x : kept_along(breaks.along[0], breaks.gap))
    for (const Interval& y : kept_along(breaks.along[1], breaks.gap))
      parts.push_back({{x.min, y.min}, {x.max, y.max}, {x.shift, y.shift}});
  return parts;
}

std::vector<std::array<double, 2>> kept_of_line(const Breaks& breaks, const Vec2& from, const Vec2& to) {
  std::vector<std::array<double, 2>> kept;
  for (const KeptPart& part : kept_parts(breaks))
    if (const auto inside = inside_part(part, from, to)) kept.push_back(*inside);
  std::sort(kept.begin(), kept.end());
  for (const auto& [begin, end] : kept)
    check(begin >= 0 && begin <= end && end <= 1, "a part that is kept lies on its line");
  return kept;
}

std::vector<std::array<Vec2, 2>> remaining_line(const Breaks& breaks, const Vec2& from, const Vec2& to) {
  for (const int axis : {0, 1}) {
    if (std::abs(to[axis] - from[axis]) > rounding_mm) continue;
    const Vec2 a = breaks.moved(from), b = breaks.moved(to);
    for (const LeftOut& strip : breaks.along[axis])
      if (from[axis] > strip.from + rounding_mm && from[axis] < strip.to - rounding_mm) return {};
    return glm::distance(a, b) > rounding_mm ? std::vector{std::array{a, b}} : std::vector<std::array<Vec2, 2>>{};
  }
  std::vector<std::array<Vec2, 2>> lines;
  for (const KeptPart& part : kept_parts(breaks))
    if (const auto inside = inside_part(part, from, to))
      lines.push_back({from + (*inside)[0] * (to - from) + part.shift, from + (*inside)[1] * (to - from) + part.shift});
  return lines;
}

Vec2 position_on_page(const ViewDrawing& drawing, const Vec3& point) {
  const Vec4 page = drawing.world_to_page * Vec4(point, 1);
  return drawing.shown.breaks.moved(Vec2(page) / page.w);
}

void break_drawing(ViewDrawing& drawing, const Breaks& breaks, const Progress& progress) {
  progress.begin("breaking the view", drawing.segments.size());
  std::vector<Limit> limits = straight_limits(drawing, breaks);
  ViewDrawing all;
  std::vector<PaperTriangle> before_cuts;
  std::vector<BrokenOut> broken_out = drawing.cuts.broken_out;
  for (BrokenOut& one : broken_out) one.lines.clear();
  for (const KeptPart& part : kept_parts(breaks)) {
    progress.expect_time();
    ViewDrawing kept = part_of(drawing, part, breaks, limits);
    check(kept.cuts.broken_out.size() == broken_out.size(), "every part knows all broken-out sections");
    for (std::size_t i = 0; i < broken_out.size(); ++i)
      broken_out[i].lines.insert(broken_out[i].lines.end(), kept.cuts.broken_out[i].lines.begin(),
                                 kept.cuts.broken_out[i].lines.end());
    append_part(all, std::move(kept));
    // What hides hatching may reach over freehand lines, where no hatching is.
    KeptPart wide = part;
    for (const int axis : {0, 1}) {
      if (is_freehand(breaks, axis, part.min[axis])) wide.min[axis] -= freehand_wave;
      if (is_freehand(breaks, axis, part.max[axis])) wide.max[axis] += freehand_wave;
    }
    for (const PaperTriangle& triangle : drawing.cuts.before) add_part(before_cuts, triangle, wide);
  }
  std::vector<std::array<Vec2, 2>> traces;
  for (const auto& [from, to] : drawing.aids.traces)
    for (const auto& line : remaining_line(breaks, from, to)) traces.push_back(line);
  drawing.aids.traces = std::move(traces);
  drawing.segments = std::move(all.segments);
  drawing.crossings = std::move(all.crossings);
  drawing.cuts.faces = std::move(all.cuts.faces);
  drawing.cuts.before = std::move(before_cuts);
  drawing.cuts.broken_out = std::move(broken_out);
  chain_lines(drawing, progress);
  drawing.box.min = breaks.moved(drawing.box.min);
  drawing.box.max = breaks.moved(drawing.box.max);
  drawing.shown.breaks = breaks;
  drawing.shown.limits = std::move(limits);
}

}  // namespace epura::drawing
