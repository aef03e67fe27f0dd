// SPDX-License-Identifier: Apache-2.0
#include "sheet/real_dashes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "sheet/walk_stroke.hpp"

namespace epura::sheet {

namespace {

Vec2 point_at(const drawing::CurvePart& curve, double angle) {
  return curve.centre + portable_cos(angle) * curve.u + portable_sin(angle) * curve.v;
}

/// A straight part of a stroke, or a curve, which knows its length up to each of its steps.
struct StrokePart {
  Vec2 from, to;
  std::optional<drawing::CurvePart> curve{};
  std::vector<double> lengths{};  ///< of a curve, at the ends of equal steps of its angle

  [[nodiscard]] double length() const { return curve ? lengths.back() : glm::distance(from, to); }
  [[nodiscard]] double angle_at(double along) const;
  void append_to(Stroke& dash, double begin, double end) const;
};

// Chords of a degree are shorter than their arcs by 1 in 80 000: what is left of a dash of 10 mm is below 0.0002 mm.
constexpr double angle_step = std::numbers::pi / 180;

int steps_of(double sweep) { return std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / angle_step))); }

StrokePart part_of(const drawing::CurvePart& curve) {
  StrokePart part{point_at(curve, curve.from), point_at(curve, curve.to), curve, {0}};
  const int steps = steps_of(curve.to - curve.from);
  Vec2 last = part.from;
  for (int i = 1; i <= steps; ++i) {
    const Vec2 next = point_at(curve, curve.from + (curve.to - curve.from) * i / steps);
    part.lengths.push_back(part.lengths.back() + glm::distance(last, next));
    last = next;
  }
  return part;
}

double StrokePart::angle_at(double along) const {
  const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, along);
  const double before = *std::prev(next), step = *next - before;
  const double steps =
      static_cast<double>(next - lengths.begin()) - 1 + (step > 0 ? std::clamp((along - before) / step, 0.0, 1.0) : 0);
  return curve->from + (curve->to - curve->from) * steps / static_cast<double>(lengths.size() - 1);
}

// Adds what lies between two distances from the beginning of this part.
void StrokePart::append_to(Stroke& dash, double begin, double end) const {
  const double whole = length();
  check(begin <= end && end <= whole, "a dash is within its part of the line");
  const auto at = [&](double along) { return whole > 0 ? from + along / whole * (to - from) : from; };
  if (!curve) {
    if (dash.points.empty()) dash.points.push_back(at(begin));
    dash.points.push_back(at(end));
    return;
  }
  drawing::CurvePart piece = *curve;
  piece.from = angle_at(begin);
  piece.to = angle_at(end);
  if (dash.points.empty()) dash.points.push_back(point_at(piece, piece.from));
  piece.first = static_cast<int>(dash.points.size()) - 1;
  const int steps = steps_of(piece.to - piece.from);
  for (int i = 1; i <= steps; ++i)
    dash.points.push_back(point_at(piece, piece.from + (piece.to - piece.from) * i / steps));
  piece.last = static_cast<int>(dash.points.size()) - 1;
  dash.curves.push_back(piece);
}

std::vector<StrokePart> parts_of(const Stroke& stroke) {
  std::vector<StrokePart> parts;
  Vec2 here = stroke.points.front();
  walk_stroke(
      stroke,
      [&](const Vec2& point) {
        parts.push_back({here, point});
        here = point;
      },
      [&](const drawing::CurvePart& curve) {
        parts.push_back(part_of(curve));
        here = parts.back().to;
      });
  if (stroke.closed) parts.push_back({here, stroke.points.front()});
  std::erase_if(parts, [](const StrokePart& part) { return !(part.length() > 0); });
  return parts;
}

// Ink and gaps in turn.
std::vector<double> pattern_of(const Stroke& stroke) {
  if (!stroke.pattern.empty()) return stroke.pattern;
  if (!(stroke.dashes.dash > 0)) return {};
  std::vector<double> pattern{stroke.dashes.dash, stroke.dashes.gap};
  for (int i = 0; i < stroke.dashes.dots; ++i) pattern.insert(pattern.end(), {stroke.dashes.dot, stroke.dashes.gap});
  return pattern;
}

// The dashes of a stroke; the stroke itself if it is continuous.
std::vector<Stroke> dashes_of(const Stroke& stroke) {
  const std::vector<double> pattern = pattern_of(stroke);
  constexpr double min_period = 1e-3;  // mm: finer than any pen
  double period = 0;
  for (const double length : pattern) period += length;
  if (!(period > min_period) || stroke.points.size() < 2) return {stroke};
  Stroke like = stroke;  // without its form
  like.points.clear();
  like.curves.clear();
  like.pattern.clear();
  like.dashes = {};
  like.closed = false;
  std::vector<Stroke> dashes;
  constexpr double nothing = 1e-6;  // mm: left of a dash by rounding
  std::size_t now = 0;
  while (!(pattern[now] > nothing)) ++now;
  double left = pattern[now];
  Stroke dash = like;
  const auto finish = [&] {
    if (now % 2 == 0 && dash.points.size() > 1) dashes.push_back(std::move(dash));
    dash = like;
  };
  for (const StrokePart& part : parts_of(stroke)) {
    const double length = part.length();
    for (double at = 0; length - at > nothing;) {
      const double end = std::min(length, at + left);
      if (now % 2 == 0 && end - at > nothing) part.append_to(dash, at, end);
      left -= end - at;
      at = end;
      if (left > nothing) continue;
      finish();
      do now = (now + 1) % pattern.size();
      while (!(pattern[now] > nothing));
      left = pattern[now];
    }
  }
  finish();
  for (const Stroke& one : dashes) check(one.points.size() > 1 && !one.closed, "a dash is an open line");
  return dashes;
}

// A run of the old strokes as one of the new ones; `begins` has the new number of each old one, and of the end.
InkRange moved(const InkRange& old, const std::vector<std::size_t>& begins) {
  return {begins.at(old.begin), begins.at(old.end)};
}

void make_real(Layer& layer) {
  std::vector<Stroke> strokes;
  std::vector<std::size_t> begins;
  for (const Stroke& stroke : layer.strokes) {
    begins.push_back(strokes.size());
    for (Stroke& dash : dashes_of(stroke)) strokes.push_back(std::move(dash));
  }
  begins.push_back(strokes.size());
  check(begins.size() == layer.strokes.size() + 1, "each stroke has its place among the dashes");
  layer.strokes = std::move(strokes);
  layer.style.dashes = {};
  const auto move = [&](auto& objects) {
    for (auto& object : objects) object.strokes = moved(object.strokes, begins);
  };
  move(layer.hatched);
  move(layer.dimensions);
  move(layer.leaders);
  move(layer.tolerances);
  move(layer.tables);
}

}  // namespace

Sheet with_real_dashes(Sheet sheet) {
  for (Layer& layer : sheet.layers) make_real(layer);
  return sheet;
}

}  // namespace epura::sheet
