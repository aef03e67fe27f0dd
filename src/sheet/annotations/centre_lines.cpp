// SPDX-License-Identifier: Apache-2.0
#include "annotations/centre_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "annotations/seen_circle.hpp"
#include "annotations/seen_features.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "drawing/drawing.hpp"
#include "sheet/dash.hpp"
#include "visibility/spans.hpp"

namespace epura::sheet {

namespace {

constexpr double past_rim = 3;                // mm
constexpr double min_diameter = 3;            // mm
constexpr double shortest_piece = 1;          // mm, of the pieces that other lines leave
constexpr double same_axis_place = 0.02;      // mm
constexpr double short_of_end = 0.75;         // mm, by which facets of a rim may fall short of its circle
constexpr double same_axis_direction = 1e-4;  // radians
constexpr double min_opening = 0.25;          // part of a rim that is seen
constexpr double whole_opening = 0.95;

/// A piece of the line at offset * normal along the direction of `angle`; the normal is 90 degrees further.
struct Piece {
  double angle, offset;
  double from, to;
  bool centred = true;  ///< requires ink in its middle

  [[nodiscard]] Vec2 direction() const { return {portable_cos(angle), portable_sin(angle)}; }
  [[nodiscard]] Vec2 at(double s) const {
    const Vec2 d = direction();
    return s * d + offset * Vec2(-d.y, d.x);
  }
};

// Angles from 0 to pi, except that those just below pi count as just below 0; rounded, so that parallel lines share it.
double angle_of_line(const Vec2& direction) {
  double angle = portable_atan2(direction.y, direction.x);
  if (angle < -same_axis_direction) angle += std::numbers::pi;
  if (angle > std::numbers::pi - same_axis_direction) angle -= std::numbers::pi;
  return std::round(angle * 1e9) / 1e9;
}

double offset_of(double angle, const Vec2& p) { return portable_cos(angle) * p.y - portable_sin(angle) * p.x; }
double place_along(double angle, const Vec2& p) { return portable_cos(angle) * p.x + portable_sin(angle) * p.y; }

// A class number for each value; values no more than `apart` from the next one share a class.
std::vector<int> classes_of(const std::vector<double>& values, double apart) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return std::pair(values[a], a) < std::pair(values[b], b); });
  std::vector<int> classes(values.size());
  int number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && values[order[i]] - values[order[i - 1]] > apart) ++number;
    classes[order[i]] = number;
  }
  return classes;
}

// Groups of indices of items that are close to each other in both values.
std::vector<std::vector<std::size_t>> groups_of_axes(const std::vector<double>& a, double a_apart,
                                                     const std::vector<double>& b, double b_apart) {
  const std::vector<int> first = classes_of(a, a_apart), second = classes_of(b, b_apart);
  std::map<std::pair<int, int>, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < a.size(); ++i) groups[{first[i], second[i]}].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [key, group] : groups) result.push_back(std::move(group));
  return result;
}

template <class Value>
std::vector<double> values_of(const auto& things, const Value& value) {
  std::vector<double> values;
  for (const auto& thing : things) values.push_back(value(thing));
  return values;
}

Piece piece_about(const Vec2& centre, const Vec2& direction, double half) {
  const double angle = angle_of_line(direction), middle = place_along(angle, centre);
  return {angle, offset_of(angle, centre), middle - half, middle + half};
}

std::vector<Piece> crosses(const std::vector<std::vector<SeenCircle>>& features) {
  std::vector<SeenCircle> round;
  for (const std::vector<SeenCircle>& circles : features)
    std::copy_if(circles.begin(), circles.end(), std::back_inserter(round), [](const auto& c) { return c.is_round(); });
  std::vector<Piece> pieces;
  const auto x = values_of(round, [](const auto& c) { return c.centre.x; });
  const auto y = values_of(round, [](const auto& c) { return c.centre.y; });
  for (const auto& group : groups_of_axes(x, same_axis_place, y, same_axis_place)) {
    double radius = 0;
    std::optional<Vec2> spoke;
    for (const std::size_t i : group) {
      radius = std::max(radius, round[i].radius());
      if (round[i].spoke) spoke = round[i].spoke;
    }
    const Vec2& beside = round[group.front()].beside;
    const Vec2 centre = round[group.front()].centre;
    if (spoke)
      pieces.push_back(piece_about(centre, *spoke, radius + past_rim));
    else
      for (const Vec2& direction : {beside, Vec2(-beside.y, beside.x)})
        pieces.push_back(piece_about(centre, direction, radius + past_rim));
  }
  check(pieces.size() <= 2 * round.size(), "a circle has two centre lines at most");
  return pieces;
}

// The axis through circles on one line: two that are apart, or one that is seen edge-on.
std::optional<Piece> axis_through(std::span<const SeenCircle> circles) {
  const double angle = angle_of_line(largest_of(circles).axis);
  Piece piece{angle, offset_of(angle, circles.front().centre), HUGE_VAL, -HUGE_VAL};
  double first = HUGE_VAL, last = -HUGE_VAL;  // of the centres
  bool alone = false;                         // one of them suffices
  for (const SeenCircle& circle : circles) {
    const double middle = place_along(angle, circle.centre), reach = circle.reach(piece.direction());
    piece.from = std::min(piece.from, middle - reach - past_rim);
    piece.to = std::max(piece.to, middle + reach + past_rim);
    first = std::min(first, middle);
    last = std::max(last, middle);
    alone = alone || reach <= edge_on * circle.radius();
  }
  return alone || last - first > same_axis_place ? std::optional(piece) : std::nullopt;
}

// Circles of one feature belong together; single rims on one line in the view are treated as one feature.
std::vector<Piece> axes(const std::vector<std::vector<SeenCircle>>& features) {
  std::vector<Piece> pieces;
  std::vector<SeenCircle> rims;
  const auto add_axis = [&](const std::vector<SeenCircle>& circles) {
    if (const auto piece = axis_through(circles)) pieces.push_back(*piece);
  };
  for (const std::vector<SeenCircle>& circles : features) {
    if (!largest_of(circles).is_slanted()) continue;
    if (circles.size() == 1)
      rims.push_back(circles.front());
    else
      add_axis(circles);
  }
  const auto angles = values_of(rims, [](const auto& c) { return angle_of_line(c.axis); });
  const auto offsets = values_of(rims, [](const auto& c) { return offset_of(angle_of_line(c.axis), c.centre); });
  for (const auto& group : groups_of_axes(angles, same_axis_direction, offsets, same_axis_place)) {
    std::vector<SeenCircle> circles;
    for (const std::size_t i : group) circles.push_back(rims[i]);
    add_axis(circles);
  }
  check(pieces.size() <= features.size(), "a feature has one axis at most");
  return pieces;
}

// Merges overlapping pieces of one line.
std::vector<Piece> merged(const std::vector<Piece>& pieces) {
  const auto angles = values_of(pieces, [](const Piece& p) { return p.angle; });
  const auto offsets = values_of(pieces, [](const Piece& p) { return p.offset; });
  std::vector<Piece> result;
  for (const auto& group : groups_of_axes(angles, same_axis_direction, offsets, same_axis_place)) {
    std::vector<Piece> line;
    for (const std::size_t i : group) line.push_back(pieces[i]);
    std::sort(line.begin(), line.end(), [](const Piece& a, const Piece& b) { return a.from < b.from; });
    const std::size_t begin = result.size();
    for (const Piece& piece : line) {
      if (result.size() == begin || piece.from > result.back().to) {
        result.push_back(piece);
        continue;
      }
      Piece& last = result.back();
      const bool same_middle = std::abs(last.from + last.to - piece.from - piece.to) <= 2 * same_axis_place;
      last.centred = last.centred && same_middle;
      last.to = std::max(last.to, piece.to);
      check(last.from <= piece.from, "pieces of a line are in order");
    }
  }
  return result;
}

/// The parts of pieces that are covered by lines of other layers.
class Covers {
 public:
  Covers(const std::vector<Piece>& pieces, double apart) : pieces_(pieces), apart_(apart), taken_(pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i) by_line_.insert({pieces[i].angle, pieces[i].offset, i});
    for (const Piece& piece : pieces) angles_.insert(piece.angle);
  }

  void add(const Vec2& from, const Vec2& to) {
    for (const double angle : angles_) {
      const double a = offset_of(angle, from), b = offset_of(angle, to);
      if (std::abs(a - b) > apart_) continue;
      const double s = place_along(angle, from), t = place_along(angle, to);
      for (auto i = by_line_.lower_bound({angle, std::max(a, b) - apart_, 0});
           i != by_line_.end() && std::get<0>(*i) == angle && std::get<1>(*i) <= std::min(a, b) + apart_; ++i)
        taken_[std::get<2>(*i)].push_back({std::min(s, t), std::max(s, t)});
    }
  }

  /// The uncovered parts.
  [[nodiscard]] std::vector<Piece> rest() const {
    std::vector<Piece> left;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      std::vector<std::array<double, 2>> taken = taken_[i];
      std::sort(taken.begin(), taken.end());
      taken.push_back({HUGE_VAL, HUGE_VAL});
      Piece piece = pieces_[i];
      for (const auto& [low, high] : taken) {
        Piece part = piece;
        part.to = std::min(pieces_[i].to, low);
        part.centred = part.from == pieces_[i].from && part.to == pieces_[i].to && piece.centred;
        if (part.to - part.from >= shortest_piece) left.push_back(part);
        check(high >= low, "what covers a line has a length");
        piece.from = std::max(piece.from, high);
      }
    }
    return left;
  }

 private:
  const std::vector<Piece>& pieces_;
  double apart_;
  std::vector<std::vector<std::array<double, 2>>> taken_;
  std::set<std::tuple<double, double, std::size_t>> by_line_;
  std::set<double> angles_;
};

std::vector<Piece> uncovered_parts(const std::vector<Piece>& pieces, std::span<const Layer> drawn, double apart,
                                   const Progress& progress) {
  Covers covers(pieces, apart);
  for (const Layer& layer : drawn) {
    for (const Stroke& stroke : layer.strokes) {
      progress.expect_time();
      const std::size_t lines = stroke.points.size() - (stroke.closed || stroke.points.empty() ? 0 : 1);
      for (std::size_t i = 0; i < lines; ++i)
        covers.add(stroke.points[i], stroke.points[(i + 1) % stroke.points.size()]);
    }
  }
  return covers.rest();
}

/// What to draw in a view.
struct Marks {
  std::vector<std::vector<SeenCircle>> features;
  std::vector<Piece> pieces;       ///< of slots
  std::vector<SeenCircle> rounds;  ///< pitch circles
};

// The axis of a feature that is seen only through its ends, where it passes through openings: `seen` is by ring.
void add_in_openings(Marks& marks, const std::vector<SeenCircle>& rings, const std::vector<SeenRim>& seen) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (seen[i].turn < min_opening) continue;
    const Vec2 along = glm::normalize(rings[i].axis);
    Piece piece = piece_about(rings[i].centre, along, rings[i].reach(along) + past_rim);
    if (seen[i].turn < whole_opening) {
      const auto places = values_of(seen[i].points, [&](const Vec2& p) { return place_along(piece.angle, p); });
      const auto [low, high] = std::minmax_element(places.begin(), places.end());
      piece.from = std::max(piece.from, *low - past_rim);
      piece.to = std::min(piece.to, *high + past_rim);
      piece.centred = false;
    }
    marks.pieces.push_back(piece);
  }
}

// Where lines are seen on both sides of an axis, and between such places, where something covers one side. Seen from
// the side, one suffices, since the other contour is often an edge, too.
visibility::Spans seen_about(const std::vector<SeenCircle>& rings, const std::array<visibility::Spans, 2>& sides) {
  visibility::Spans any = sides[0], both;
  for (const auto& span : sides[1]) visibility::add_span(any, span);
  if (largest_of(rings).is_edge_on()) return any;
  for (const auto& [from, to] : sides[0])
    for (const auto& [begin, end] : sides[1])
      if (std::max(from, begin) < std::min(to, end))
        visibility::add_span(both, {std::max(from, begin), std::min(to, end)});
  visibility::Spans seen;
  for (const auto& span : both) {
    if (!seen.empty() && visibility::covers(any, seen.back()[1], span[0]))
      seen.back()[1] = span[1];
    else
      seen.push_back(span);
  }
  return seen;
}

// The axis of a feature, or of the parts of one, where it is seen.
void add_where_seen(Marks& marks, const std::vector<SeenCircle>& rings, const SeenFeatures& seen,
                    std::span<const features::CentredRound> parts) {
  const auto axis = axis_through(rings);
  if (!axis) return;
  std::array<visibility::Spans, 2> sides;
  for (const features::CentredRound& part : parts)
    seen.add_beside(part, {axis->at(0), axis->direction(), past_rim}, sides);
  for (const auto& [from, to] : seen_about(rings, sides)) {
    Piece piece = *axis;
    if (from > axis->from + short_of_end) piece.from = from;
    if (to < axis->to - short_of_end) piece.to = to;
    piece.centred = piece.from == axis->from && piece.to == axis->to;
    if (piece.to - piece.from >= shortest_piece) marks.pieces.push_back(piece);
  }
}

// The rings of the second end of a slot may be in the opposite order. Each of them has half a rim.
std::vector<SeenRim> rims_of(const SeenFeatures& seen, const features::CentredSlot& slot) {
  const auto& [one, other] = slot.ends;
  std::vector<SeenRim> rims = seen.rims(one), there = seen.rims(other);
  if (glm::dot(one.axis, other.axis) < 0) std::reverse(there.begin(), there.end());
  for (std::size_t i = 0; i < std::min(rims.size(), there.size()); ++i) {
    rims[i].turn += there[i].turn;
    rims[i].points.insert(rims[i].points.end(), there[i].points.begin(), there[i].points.end());
  }
  return rims;
}

// If seen in true shape: a line through both ends and another across each end; otherwise one axis in the middle.
void add_slot(Marks& marks, const drawing::ViewDrawing& drawing, const SeenFeatures& seen,
              const features::CentredSlot& slot) {
  const auto [one, other] = slot.ends;
  check(!one.rings.empty() && !other.rings.empty(), "an end of a slot has a rim");
  const SeenCircle a = see(drawing, one.axis, one.rings.front()), b = see(drawing, other.axis, other.rings.front());
  if (a.is_round()) {
    const Vec2 way = b.centre - a.centre, direction = glm::normalize(way);
    const double half = a.radius() + past_rim;
    marks.pieces.push_back(piece_about(0.5 * (a.centre + b.centre), direction, glm::length(way) / 2 + half));
    for (const SeenCircle& end : {a, b})
      marks.pieces.push_back(piece_about(end.centre, {-direction.y, direction.x}, half));
    return;
  }
  const Vec3 apart = other.rings.front().centre - one.rings.front().centre;
  const Vec3 half = 0.5 * (apart - glm::dot(apart, one.axis) * one.axis);
  features::CentredRound middle = one;
  for (features::Ring& ring : middle.rings) ring.centre += half;
  const std::vector<SeenCircle> rings = see(drawing, middle);
  if (seen.is_inside(one)) {
    add_in_openings(marks, rings, rims_of(seen, slot));
  } else if (seen.is_in_parts(one)) {
    add_where_seen(marks, rings, seen, slot.ends);
  } else {
    marks.features.push_back(rings);
  }
}

// Between the axes of an arm that are seen as points.
void add_arm(Marks& marks, const drawing::ViewDrawing& drawing, const features::CentredRound& one,
             const features::CentredRound& other) {
  const SeenCircle a = see(drawing, one.axis, one.rings.front()), b = see(drawing, other.axis, other.rings.front());
  const Vec2 way = b.centre - a.centre;
  if (a.is_round() && glm::length(way) >= shortest_piece)
    marks.pieces.push_back(piece_about(0.5 * (a.centre + b.centre), glm::normalize(way), glm::length(way) / 2));
}

bool is_small(std::span<const SeenCircle> rings) { return 2 * largest_of(rings).radius() < min_diameter; }

Marks marks_of(const CentredView& view) {
  const SeenFeatures seen(view.drawing, view.styles);
  const features::CentredFeatures& features = view.features;
  std::vector<int> circle_of(features.round.size(), -1);
  for (std::size_t c = 0; c < features.pitch_circles.size(); ++c)
    for (const int hole : features.pitch_circles[c].holes) {
      check(hole >= 0 && hole < static_cast<int>(circle_of.size()), "holes on a pitch circle are round features");
      circle_of[hole] = static_cast<int>(c);
    }
  Marks marks;
  std::set<int> circles;
  for (std::size_t i = 0; i < features.round.size(); ++i) {
    std::vector<SeenCircle> rings = see(view.drawing, features.round[i]);
    const bool is_on_circle = circle_of[i] >= 0 && largest_of(rings).is_round();
    if (features.round[i].beside != Vec3(0))
      for (SeenCircle& ring : rings) ring.beside = image_of(view.drawing, features.round[i].beside, 0);
    if ((is_small(rings) && !is_on_circle) || !seen.shows(features.round[i])) continue;
    const auto is_kept = [&](const SeenCircle& ring) { return view.drawing.shown.breaks.keeps(ring.centre); };
    if (std::none_of(rings.begin(), rings.end(), is_kept)) continue;
    if (is_on_circle) {
      circles.insert(circle_of[i]);
      const Vec2 middle = image_of(view.drawing, features.pitch_circles[circle_of[i]].centre, 1);
      for (SeenCircle& ring : rings) ring.spoke = ring.centre - middle;
    }
    if (!largest_of(rings).is_round() && seen.is_inside(features.round[i]))
      add_in_openings(marks, rings, seen.rims(features.round[i]));
    else if (!largest_of(rings).is_round() && seen.is_in_parts(features.round[i]))
      add_where_seen(marks, rings, seen, {&features.round[i], 1});
    else
      marks.features.push_back(std::move(rings));
  }
  for (const features::CentredSlot& slot : features.slots)
    if (!is_small(see(view.drawing, slot.ends[0])) && (seen.shows(slot.ends[0]) || seen.shows(slot.ends[1])))
      add_slot(marks, view.drawing, seen, slot);
  for (const auto& [ends, width] : features.arms)
    if (seen.shows(features.round[ends[0]]) && seen.shows(features.round[ends[1]]))
      add_arm(marks, view.drawing, features.round[ends[0]], features.round[ends[1]]);
  for (const int c : circles) {
    const features::PitchCircle& pitch = features.pitch_circles[c];
    marks.rounds.push_back(see(view.drawing, pitch.axis, {pitch.centre, pitch.radius}));
  }
  return marks;
}

// Whether a break leaves out all of a piece but what extends past its feature.
bool is_left_out(const drawing::Breaks& breaks, const Piece& piece) {
  const double overshoot = std::min(past_rim, (piece.to - piece.from) / 2);
  const Vec2 from = piece.at(piece.from + overshoot), to = piece.at(piece.to - overshoot);
  for (const int axis : {0, 1})
    for (const drawing::LeftOut& strip : breaks.along[axis])
      if (std::min(from[axis], to[axis]) > strip.from && std::max(from[axis], to[axis]) < strip.to) return true;
  return false;
}

// What the breaks of a view leave of the pieces.
std::vector<Piece> remaining(const drawing::Breaks& breaks, std::vector<Piece> pieces) {
  if (!breaks.any()) return pieces;
  std::erase_if(pieces, [&](const Piece& piece) { return is_left_out(breaks, piece); });
  std::vector<Piece> left;
  for (const Piece& piece : pieces)
    for (const auto& [from, to] : drawing::remaining_line(breaks, piece.at(piece.from), piece.at(piece.to))) {
      Piece part{piece.angle, offset_of(piece.angle, from), place_along(piece.angle, from),
                 place_along(piece.angle, to), false};
      part.centred = piece.centred && std::abs(part.to - part.from - (piece.to - piece.from)) <= same_axis_place;
      if (part.to - part.from >= shortest_piece) left.push_back(part);
    }
  return left;
}

// The part of a piece in a detail; a piece that is cut off has no middle.
std::optional<Piece> inside(const std::optional<drawing::DetailFrame>& detail, Piece piece) {
  if (!detail) return piece;
  const auto part = drawing::part_inside(detail->boundary, piece.at(piece.from), piece.at(piece.to));
  const double length = piece.to - piece.from;
  if (!part || ((*part)[1] - (*part)[0]) * length < shortest_piece) return std::nullopt;
  piece.centred = piece.centred && std::abs((*part)[0] + (*part)[1] - 1) * length <= same_axis_place;
  piece.to = piece.from + (*part)[1] * length;
  piece.from += (*part)[0] * length;
  return piece;
}

Stroke arc_stroke(const SeenCircle& circle, const drawing::AngleRange& range, double width) {
  const double turn = range.to - range.from, radius = circle.radius();
  const int steps = std::max(1, static_cast<int>(std::ceil(turn * 90 / std::numbers::pi)));
  Stroke stroke{{}, false, fit_open(turn * radius, width, scene::long_dash_dot)};
  for (int i = 0; i <= steps; ++i) {
    const double a = range.from + turn * i / steps;
    stroke.points.push_back(circle.centre + radius * Vec2(portable_cos(a), portable_sin(a)));
  }
  stroke.curves = {{0, steps, circle.centre, {radius, 0}, {0, radius}, range.from, range.to}};
  return stroke;
}

Stroke round_stroke(const SeenCircle& circle, double width) {
  constexpr int steps = 180;
  Stroke stroke{{}, true, fit_closed(2 * std::numbers::pi * circle.radius(), width, scene::long_dash_dot)};
  for (int i = 0; i < steps; ++i) {
    const double a = 2 * std::numbers::pi * i / steps;
    stroke.points.push_back(circle.centre + circle.radius() * Vec2(portable_cos(a), portable_sin(a)));
  }
  stroke.curves = {{0, steps, circle.centre, {circle.radius(), 0}, {0, circle.radius()}, 0, 2 * std::numbers::pi}};
  return stroke;
}

// The parts of a circle inside a boundary, moved.
void add_round_strokes(std::vector<Stroke>& strokes, const SeenCircle& circle, const drawing::Boundary& boundary,
                       const Vec2& shift, double width) {
  SeenCircle moved = circle;
  moved.centre += shift;
  for (const drawing::AngleRange& range : drawing::circle_inside(boundary, circle.centre, circle.radius()))
    strokes.push_back(range.to - range.from < 2 * std::numbers::pi ? arc_stroke(moved, range, width)
                                                                   : round_stroke(moved, width));
}

std::vector<Stroke> round_strokes(const SeenCircle& circle, const drawing::ViewDrawing& drawing, double width) {
  std::vector<Stroke> strokes;
  if (!drawing.shown.detail && !drawing.shown.breaks.any()) return {round_stroke(circle, width)};
  if (drawing.shown.detail) add_round_strokes(strokes, circle, drawing.shown.detail->boundary, {0, 0}, width);
  if (!drawing.shown.breaks.any()) return strokes;
  const Vec2 reach(circle.radius() + past_rim);
  for (const drawing::KeptPart& part : drawing::kept_parts(drawing.shown.breaks)) {
    const Vec2 min = glm::max(part.min, circle.centre - reach), max = glm::min(part.max, circle.centre + reach);
    if (min.x < max.x && min.y < max.y)
      add_round_strokes(strokes, circle, {(min + max) / 2.0, (max - min) / 2.0, false}, part.shift, width);
  }
  return strokes;
}

}  // namespace

Layer centre_lines(const CentredView& view, const LineWidths& widths, std::span<const Layer> drawn,
                   const Progress& progress) {
  Layer layer = empty_layer(view.drawing.name, scene::SheetLine::centre, widths);
  const double width = layer.style.width;
  if (view.drawing.projection.central) return layer;
  const Marks marks = marks_of(view);
  std::vector<Piece> pieces = axes(marks.features);
  for (const Piece& piece : crosses(marks.features)) pieces.push_back(piece);
  pieces.insert(pieces.end(), marks.pieces.begin(), marks.pieces.end());
  pieces = remaining(view.drawing.shown.breaks, merged(pieces));
  const auto& detail = view.drawing.shown.detail;
  for (const Piece& whole : uncovered_parts(pieces, drawn, width / 2, progress)) {
    const auto piece = inside(detail, whole);
    if (!piece) continue;
    const double length = piece->to - piece->from;
    check(length > 0, "a centre line has a length");
    const Dashes dashes = piece->centred ? fit_centred(length, width, scene::long_dash_dot)
                                         : fit_open(length, width, scene::long_dash_dot);
    layer.strokes.push_back({{piece->at(piece->from), piece->at(piece->to)}, false, dashes});
  }
  for (const SeenCircle& circle : marks.rounds)
    for (Stroke& stroke : round_strokes(circle, view.drawing, width)) layer.strokes.push_back(std::move(stroke));
  return layer;
}

}  // namespace epura::sheet
