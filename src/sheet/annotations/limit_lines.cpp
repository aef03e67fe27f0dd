// SPDX-License-Identifier: Apache-2.0
#include "annotations/limit_lines.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/range.hpp"
#include "drawing/drawing.hpp"
#include "sheet/dash.hpp"
#include "sheet/furniture.hpp"

namespace epura::sheet {

namespace {

// A zigzag in line widths: 14 across the line and 7.5 along it, which makes angles of 30 degrees; one for each 80 mm of
// the line, and one more. ISO 128-2.
constexpr double zigzag_across = 14, zigzag_along = 7.5;
constexpr double zigzag_every = 80;     // mm
constexpr double off_limit_axis = 0.3;  // position of a zigzag in its part of the line: a centre line is in the middle
constexpr double past_limits = 3;       // mm
constexpr double past_symmetric = 6;    // mm; room for the symbol
// The symbol for symmetry: distances of its lines from the outline, and their length, mm.
constexpr double symbol_begin = 2.5, symbol_apart = 1.5, symbol_length = 3.5;
constexpr double same_line = 0.05;  // mm

struct Ends {
  Vec2 from, to, along;
};

Ends ends_of(const drawing::Limit& limit, double past) {
  const Vec2 along = glm::normalize(limit.to - limit.from);
  return {limit.from - (limit.meets[0] ? 0 : past) * along, limit.to + (limit.meets[1] ? 0 : past) * along, along};
}

int axis_of_limit(const drawing::Limit& limit) {
  return std::abs(limit.to.x - limit.from.x) > std::abs(limit.to.y - limit.from.y) ? 0 : 1;
}

// Zigzags beside each other are at the same places of their lines: so they are parallel, and do not touch.
Range common_range(const std::vector<drawing::Limit>& limits, const drawing::Limit& limit) {
  const int axis = axis_of_limit(limit);
  const auto range_of = [axis](const drawing::Limit& one) {
    const Ends ends = ends_of(one, past_limits);
    return Range{std::min(ends.from[axis], ends.to[axis]), std::max(ends.from[axis], ends.to[axis])};
  };
  Range common = range_of(limit);
  for (const drawing::Limit& other : limits) {
    if (other.symmetric || axis_of_limit(other) != axis) continue;
    const Range range = range_of(other);
    if (range.to <= common.from || range.from >= common.to) continue;
    common = {std::max(common.from, range.from), std::min(common.to, range.to)};
  }
  return common;
}

Stroke zigzag_line(const drawing::Limit& limit, const Range& range, double width) {
  const auto [from, to, along] = ends_of(limit, past_limits);
  const Vec2 across(-along.y, along.x);
  const int axis = axis_of_limit(limit);
  const double length = range.to - range.from;
  check(length > 0, "a break line has a length");
  Vec2 begin = from;
  begin[axis] = along[axis] > 0 ? range.from : range.to;
  const int count = 1 + static_cast<int>(length / zigzag_every);
  const double half = zigzag_along * width / 2, quarter = zigzag_along * width / 4, high = zigzag_across * width / 2;
  Stroke stroke{{from}};
  for (int i = 0; i < count; ++i) {
    const Vec2 middle = begin + (i + off_limit_axis) * length / count * along;
    stroke.points.push_back(middle - half * along);
    stroke.points.push_back(middle - quarter * along + high * across);
    stroke.points.push_back(middle + quarter * along - high * across);
    stroke.points.push_back(middle + half * along);
  }
  stroke.points.push_back(to);
  return stroke;
}

void add_symbol(std::vector<Stroke>& strokes, const Vec2& end, const Vec2& outwards) {
  const Vec2 half = symbol_length / 2 * Vec2(-outwards.y, outwards.x);
  for (const double at : {symbol_begin, symbol_begin + symbol_apart}) {
    const Vec2 middle = end + at * outwards;
    strokes.push_back(line(middle - half, middle + half));
  }
}

}  // namespace

std::optional<Layer> limit_lines(const drawing::ViewDrawing& view, const LineWidths& widths) {
  const auto is_drawn = [](const drawing::BrokenOut& one) { return !one.lines.empty(); };
  if (view.shown.limits.empty() && std::none_of(view.cuts.broken_out.begin(), view.cuts.broken_out.end(), is_drawn))
    return std::nullopt;
  Layer layer = empty_layer(view.name, scene::SheetLine::limit, widths);
  for (const drawing::Limit& limit : view.shown.limits) {
    if (!limit.freehand.empty()) {
      layer.strokes.push_back({limit.freehand});
      continue;
    }
    if (!limit.symmetric) {
      layer.strokes.push_back(zigzag_line(limit, common_range(view.shown.limits, limit), widths.narrow));
      continue;
    }
    const Ends ends = ends_of(limit, 0);
    if (!limit.meets[0]) add_symbol(layer.strokes, ends.from, -ends.along);
    if (!limit.meets[1]) add_symbol(layer.strokes, ends.to, ends.along);
  }
  for (const drawing::BrokenOut& broken_out : view.cuts.broken_out)
    for (const std::vector<Vec2>& line : broken_out.lines) {
      check(line.size() >= 2, "a boundary of a broken-out section has two ends");
      Stroke& stroke = layer.strokes.emplace_back(Stroke{line});
      stroke.closed = line.front() == line.back();
      if (stroke.closed) stroke.points.pop_back();
    }
  return layer;
}

void add_symmetry_lines(Layer& centre, const drawing::ViewDrawing& view, const LineWidths& widths) {
  for (const drawing::Limit& limit : view.shown.limits) {
    if (!limit.symmetric) continue;
    const auto [from, to, along] = ends_of(limit, past_symmetric);
    const Vec2 across(-along.y, along.x), at = from;
    std::erase_if(centre.strokes, [&](const Stroke& stroke) {
      return std::all_of(stroke.points.begin(), stroke.points.end(),
                         [&](const Vec2& p) { return std::abs(glm::dot(p - at, across)) < same_line; });
    });
    Stroke axis{{from, to}};
    axis.dashes = fit_open(glm::distance(from, to), widths.narrow, scene::long_dash_dot);
    centre.strokes.push_back(axis);
  }
}

std::optional<Layer> revolved_lines(const drawing::ViewDrawing& view, const LineWidths& widths) {
  if (view.cuts.revolved.empty()) return std::nullopt;
  Layer layer = empty_layer(view.name, scene::SheetLine::revolved, widths);
  for (const drawing::RevolvedFace& face : view.cuts.revolved) {
    for (const std::vector<Vec2>& ring : face.rings) layer.strokes.emplace_back(Stroke{ring}).closed = true;
    const auto& [from, to] = face.axis;
    const Vec2 past = past_limits * glm::normalize(to - from);
    Stroke axis{{from - past, to + past}};
    axis.dashes = fit_open(glm::distance(axis.points[0], axis.points[1]), widths.narrow, scene::long_dash_dot);
    layer.strokes.push_back(std::move(axis));
  }
  return layer;
}

std::optional<Layer> trace_lines(const drawing::ViewDrawing& view, const LineWidths& widths) {
  if (view.aids.traces.empty()) return std::nullopt;
  Layer layer = empty_layer(view.name, scene::SheetLine::trace, widths);
  for (const auto& [from, to] : view.aids.traces) {
    Stroke stroke{{from, to}};
    stroke.dashes = fit_open(glm::distance(from, to), widths.narrow, scene::long_dash_dot);
    layer.strokes.push_back(stroke);
  }
  return layer;
}

double limit_room(const LineWidths& widths) { return std::max(past_symmetric, zigzag_across * widths.narrow / 2); }

}  // namespace epura::sheet
