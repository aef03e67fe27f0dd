// SPDX-License-Identifier: Apache-2.0
#include "sheet/construction_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "sheet/free_rectangles.hpp"
#include "sheet/furniture.hpp"
#include "sheet/line_styles.hpp"

namespace epura::sheet {

namespace {

using construction::Extent;
using construction::Figure;
using construction::Symbol;

constexpr double mark_radius = 0.7;                     // mm, of the circle around a point
constexpr double index_height = 0.7, index_drop = 0.3;  // of the height of the symbol
constexpr double clear = 0.5;                           // mm between a symbol and lines
constexpr double apart = 2, long_symbol = 18;           // mm between long symbols and others: they are not one text
constexpr double arrow_shaft = 9;                       // mm
constexpr int parts_of_circle = 180;
constexpr double key_width = 78, key_gap = 8;  // mm: room for figures of constant size

/// A symbol as texts, its lower left corner at the origin.
struct Lettered {
  std::vector<Text> texts;
  Vec2 size{0, 0};
  double drop = 0;  ///< of indices below the base line
};

void append(Lettered& lettered, const Symbol& symbol, const DimensionStyle& style) {
  const auto add = [&](const std::string& text, double height, double drop) {
    if (text.empty()) return;
    lettered.texts.push_back({text, {lettered.size.x, -drop}, height, 0, Align::left, "construction"});
    lettered.size.x += style.lettering.width(text, height);
    lettered.drop = std::max(lettered.drop, drop);
  };
  add(symbol.base, style.text, 0);
  add(symbol.index, index_height * style.text, index_drop * style.text);
  lettered.size.y = style.text;
}

Lettered lettered(const Symbol& symbol, const std::vector<Symbol>& also, const std::string& rest,
                  const DimensionStyle& style) {
  Lettered all;
  append(all, symbol, style);
  for (const Symbol& other : also) {
    append(all, {"≡"}, style);
    append(all, other, style);
  }
  if (!rest.empty()) append(all, {" " + rest}, style);
  return all;
}

Vec2 on_curve(const construction::Curve& curve, double angle) {
  return curve.centre + portable_cos(angle) * curve.u + portable_sin(angle) * curve.v;
}

std::vector<double> angles_of(const construction::Curve& curve) {
  const double turn = curve.to - curve.from;
  const int parts = std::max(static_cast<int>(std::ceil(parts_of_circle * turn / (2 * std::numbers::pi))), 8);
  std::vector<double> angles;
  for (int i = 0; i <= parts; ++i) angles.push_back(curve.from + turn * i / parts);
  return angles;
}

// To a symbol that is so far from its point that another might be meant.
std::optional<std::array<Vec2, 2>> leader_to(const Vec2& at, const Rectangle& symbol, double from) {
  constexpr double near = 4, gap = 0.6;  // mm
  const Vec2 end = glm::clamp(at, symbol.min - gap, symbol.max + gap);
  const double length = glm::length(end - at);
  if (length <= near) return std::nullopt;
  return std::array<Vec2, 2>{at + (end - at) * (from / length), end};
}

/// Draws a figure into a layer, lines first, then symbols where they touch least.
class Draughtsman {
 public:
  Draughtsman(Layer& layer, const ConstructionRoom& room, const DimensionStyle& style)
      : layer_(layer), room_(room), style_(style), taken_(room.taken) {}

  void draw(const Figure& figure);
  void add_taken(const std::vector<TurnedBox>& boxes) { taken_.insert(taken_.end(), boxes.begin(), boxes.end()); }

 private:
  struct Place {
    Vec2 corner;  // lower left, of the symbol
    std::size_t touched;
  };

  void add_line(const Vec2& from, const Vec2& to);
  void draw_curve(const construction::Curve& curve);
  void add_arc(const construction::Curve& curve, const std::vector<double>& angles);
  void mark(const Vec2& at);
  void point_to(const construction::Point& point);
  [[nodiscard]] std::size_t touched_by(const Rectangle& box) const;
  [[nodiscard]] std::size_t letters_under(const std::optional<std::array<Vec2, 2>>& leader) const;
  [[nodiscard]] Place best_place(const Lettered& symbol, const Vec2& at, const Vec2& outwards, double from) const;
  void letter(const Lettered& symbol, const std::vector<Vec2>& anchors, double from, const Vec2& outwards = {0, 0});
  [[nodiscard]] Vec2 exit_towards(const construction::Point& point) const;

  Layer& layer_;
  const ConstructionRoom& room_;
  const DimensionStyle& style_;
  std::vector<TurnedBox> taken_;
  std::vector<TurnedBox> letters_{};
  std::vector<Vec2> arrow_tips_{};
};

void Draughtsman::add_line(const Vec2& from, const Vec2& to) {
  layer_.strokes.push_back(line(from, to));
  taken_.push_back(line_box(from, to));
}

// The parts of a curve that are in the room.
void Draughtsman::draw_curve(const construction::Curve& curve) {
  const auto is_inside = [&](double angle) {
    const Vec2 p = on_curve(curve, angle);
    return room_.area.holds({p, p});
  };
  // Between an angle inside and one outside.
  const auto border = [&](double inside, double outside) {
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (inside + outside) / 2;
      (is_inside(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  const std::vector<double> angles = angles_of(curve);
  std::vector<double> part;
  const auto finish = [&] {
    if (part.size() > 1) add_arc(curve, part);
    part.clear();
  };
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const bool inside = is_inside(angles[i]);
    if (inside && part.empty() && i > 0) part.push_back(border(angles[i], angles[i - 1]));
    if (inside) part.push_back(angles[i]);
    if (inside || part.empty()) continue;
    part.push_back(border(part.back(), angles[i]));
    finish();
  }
  finish();
}

void Draughtsman::add_arc(const construction::Curve& curve, const std::vector<double>& angles) {
  Stroke stroke;
  for (const double angle : angles) stroke.points.push_back(on_curve(curve, angle));
  for (std::size_t i = 1; i < stroke.points.size(); ++i)
    taken_.push_back(line_box(stroke.points[i - 1], stroke.points[i]));
  stroke.curves = {
      {0, static_cast<int>(angles.size()) - 1, curve.centre, curve.u, curve.v, angles.front(), angles.back()}};
  if (angles.back() - angles.front() > 2 * std::numbers::pi - 1e-9) {
    stroke.closed = true;
    stroke.points.pop_back();
  }
  layer_.strokes.push_back(std::move(stroke));
}

void Draughtsman::mark(const Vec2& at) {
  layer_.strokes.push_back(circle_at(at, mark_radius));
  taken_.push_back(turned_box({at - mark_radius, at + mark_radius}));
}

std::size_t Draughtsman::touched_by(const Rectangle& box) const {
  const TurnedBox wide = turned_box(box.grown(clear));
  auto touched = static_cast<std::size_t>(
      std::count_if(taken_.begin(), taken_.end(), [&](const TurnedBox& other) { return overlap(wide, other); }));
  const TurnedBox wider = turned_box(box.grown(apart));
  const bool is_long = box.size().x > long_symbol;
  touched += static_cast<std::size_t>(std::count_if(letters_.begin(), letters_.end(), [&](const TurnedBox& other) {
    return (is_long || 2 * other.half.x > long_symbol) && overlap(wider, other);
  }));
  for (const drawing::ViewDrawing* view : room_.views) touched += static_cast<std::size_t>(ink_in(wide, *view));
  constexpr std::size_t outside = 1000;
  return touched + (room_.area.holds(box) ? 0 : outside);
}

std::size_t Draughtsman::letters_under(const std::optional<std::array<Vec2, 2>>& leader) const {
  if (!leader) return 0;
  const TurnedBox line = line_box((*leader)[0], (*leader)[1]);
  return static_cast<std::size_t>(std::count_if(letters_.begin(), letters_.end(),
                                                [&line](const TurnedBox& other) { return overlap(line, other); }));
}

// Around a point, near it first, and first outwards if that is a direction; `from` is kept free.
Draughtsman::Place Draughtsman::best_place(const Lettered& symbol, const Vec2& at, const Vec2& outwards,
                                           double from) const {
  constexpr std::array<double, 11> steps{0.8, 2, 3.5, 5, 7, 9, 12, 16, 20, 25, 30};
  constexpr std::array<std::array<double, 2>, 12> sides{{{1, 1},
                                                         {-1, 1},
                                                         {1, -1},
                                                         {-1, -1},
                                                         {0, 1},
                                                         {1, 0},
                                                         {0, -1},
                                                         {-1, 0},
                                                         {0.5, 1},
                                                         {-0.5, 1},
                                                         {0.5, -1},
                                                         {-0.5, -1}}};
  std::vector<Vec2> directions;
  if (outwards != Vec2(0, 0)) directions.push_back(outwards);
  for (const auto& [x, y] : sides) directions.emplace_back(x, y);
  const Vec2 half = Vec2(symbol.size.x, symbol.size.y + symbol.drop) / 2.0;
  Place best{at, ~std::size_t{0}};
  for (const double step : steps)
    for (const Vec2& side : directions) {
      const Vec2 reach = half + (from + step) * (side.x != 0 && side.y != 0 ? std::numbers::sqrt2 / 2 : 1.0);
      const Vec2 centre = at + side * reach;
      const Rectangle box{centre - half, centre + half};
      const std::size_t touched = touched_by(box) + letters_under(leader_to(at, box, from));
      if (touched < best.touched) best = {centre - half + Vec2(0, symbol.drop), touched};
      if (touched == 0) return best;
    }
  return best;
}

// At the anchor where the symbol touches least.
void Draughtsman::letter(const Lettered& symbol, const std::vector<Vec2>& anchors, double from, const Vec2& outwards) {
  Place best{{0, 0}, ~std::size_t{0}};
  Vec2 at(0, 0);
  for (const Vec2& anchor : anchors) {
    const Place place = best_place(symbol, anchor, outwards, from);
    if (place.touched < best.touched) {
      best = place;
      at = anchor;
    }
    if (best.touched == 0) break;
  }
  if (const auto leader = leader_to(at, {best.corner - Vec2(0, symbol.drop), best.corner + symbol.size}, from))
    add_line((*leader)[0], (*leader)[1]);
  for (Text text : symbol.texts) {
    text.at += best.corner;
    taken_.push_back(box_of(text, style_.lettering));
    letters_.push_back(taken_.back());
    layer_.texts.push_back(std::move(text));
  }
}

// Where the line from its guide, or from the middle of the room, leaves the room.
Vec2 Draughtsman::exit_towards(const construction::Point& point) const {
  const bool has_guide = room_.area.holds({point.guide, point.guide}) && point.guide != point.at;
  const Vec2 from = has_guide ? point.guide : room_.area.centre();
  const auto part = clipped({from, point.at}, room_.area);
  return part ? (*part)[1] : from;
}

// Several points in one direction have one arrow.
void Draughtsman::point_to(const construction::Point& point) {
  const Vec2 tip = exit_towards(point), direction = glm::normalize(point.at - tip);
  const Vec2 tail = tip - arrow_shaft * direction;
  const bool is_new = std::none_of(arrow_tips_.begin(), arrow_tips_.end(),
                                   [&tip](const Vec2& other) { return glm::length(other - tip) < 0.5; });
  if (is_new) {
    arrow_tips_.push_back(tip);
    add_line(tail, tip - style_.arrow() * direction);
    layer_.fills.push_back(arrow_at(tip, direction, style_));
    taken_.push_back(line_box(tail, tip));
  }
  const std::string far = distance_text(glm::length(point.at - tip));
  letter(lettered(point.symbol, point.also, far, style_), {(tip + tail) / 2.0, tail}, 0);
}

void Draughtsman::draw(const Figure& figure) {
  const auto is_inside = [this](const Vec2& p) { return room_.area.holds({p, p}); };
  std::vector<std::pair<const construction::Line*, std::array<Vec2, 2>>> named;
  std::vector<const construction::Line*> missed;  // beyond the room
  for (const construction::Line& one : figure.lines) {
    const auto part = clipped(one, room_.area);
    if (part) add_line((*part)[0], (*part)[1]);
    if (!one.symbol.empty() && part) named.emplace_back(&one, *part);
    if (!one.symbol.empty() && !part && one.extent == Extent::line) missed.push_back(&one);
  }
  for (const construction::Curve& curve : figure.curves) draw_curve(curve);
  for (const construction::Line* one : missed) {
    const Vec2 middle = room_.area.centre(), along = glm::normalize(one->to - one->from);
    point_to({one->symbol, one->from + glm::dot(middle - one->from, along) * along, middle});
  }
  for (const construction::Point& point : figure.points)
    if (point.marked && is_inside(point.at)) mark(point.at);
  for (const construction::Point& point : figure.points) {
    if (is_inside(point.at))
      letter(lettered(point.symbol, point.also, "", style_), {point.at}, point.marked ? mark_radius : 0,
             point.marked || point.guide == point.at ? Vec2(0, 0) : glm::normalize(point.at - point.guide));
    else if (!point.on_sheet)
      point_to(point);
  }
  for (const auto& [one, part] : named) {
    // Endless lines are lettered near their ends.
    constexpr std::array ends{0.03, 0.97, 0.1, 0.9, 0.2, 0.8, 0.3, 0.7, 0.5};
    constexpr std::array middle{0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9};
    std::vector<Vec2> anchors;
    for (const double t : one->extent == Extent::segment ? middle : ends)
      anchors.push_back(part[0] + t * (part[1] - part[0]));
    letter(lettered(one->symbol, {}, "", style_), anchors, 0);
  }
  for (const construction::Curve& curve : figure.curves) {
    if (curve.symbol.empty()) continue;
    std::vector<Vec2> anchors;
    for (const double t : {0.5, 0.125, 0.375, 0.875, 0.625, 0.05, 0.2, 0.3, 0.45, 0.55, 0.7, 0.8, 0.95})
      if (const Vec2 p = on_curve(curve, curve.from + t * (curve.to - curve.from)); is_inside(p)) anchors.push_back(p);
    letter(lettered(curve.symbol, {}, "", style_), anchors, 0);
  }
}

Figure moved(Figure figure, const Vec2& by) {
  for (construction::Point& point : figure.points) point.at += by, point.guide += by;
  for (construction::Line& one : figure.lines) one.from += by, one.to += by;
  for (construction::Curve& curve : figure.curves) curve.centre += by;
  return figure;
}

// With room for its symbols.
Rectangle box_of_key(const Figure& key) {
  constexpr double lettering = 9;
  Rectangle box = box_of(key, {{0, 0}, {0, 0}}, HUGE_VAL);
  box.min -= Vec2(1.8 * lettering, lettering);
  box.max += Vec2(1.8 * lettering, lettering);
  return box;
}

// Figures of their own: below each other on the left of the view, or where there is room.
std::size_t draw_keys(Draughtsman& hand, const Figure& figure, const ConstructionRoom& room) {
  std::vector<Rectangle> taken;
  Rectangle ink{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const drawing::ViewDrawing* view : room.views) {
    ink = united(ink, {view->min, view->max});
    taken.push_back({view->min, view->max});
  }
  for (const TurnedBox& box : room.taken) taken.push_back(around(box));
  std::size_t without_place = 0;
  for (const Figure& key : figure.keys) {
    const Rectangle box = box_of_key(key);
    const Vec2 towards(ink.min.x - box.size().x / 2 - key_gap, ink.max.y);
    const auto corner = nearest_free_position(room.area, taken, box.size(), towards);
    if (!corner) {
      ++without_place;
      continue;
    }
    hand.draw(moved(key, *corner - box.min));
    taken.push_back({*corner, *corner + box.size()});
  }
  return without_place;
}

}  // namespace

std::optional<std::array<Vec2, 2>> clipped(const construction::Line& line, const Rectangle& area) {
  const double length = glm::length(line.to - line.from);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Vec2 direction = (line.to - line.from) / length;
  double from = line.extent == Extent::line ? -HUGE_VAL : 0, to = line.extent == Extent::segment ? length : HUGE_VAL;
  for (const int axis : {0, 1}) {
    if (direction[axis] == 0) {
      if (line.from[axis] < area.min[axis] || line.from[axis] > area.max[axis]) return std::nullopt;
      continue;
    }
    double enter = (area.min[axis] - line.from[axis]) / direction[axis];
    double leave = (area.max[axis] - line.from[axis]) / direction[axis];
    if (enter > leave) std::swap(enter, leave);
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  if (!(from < to)) return std::nullopt;
  const Vec2 end = line.extent == Extent::segment && to == length ? line.to : line.from + to * direction;
  return std::array<Vec2, 2>{from == 0 ? line.from : line.from + from * direction, end};
}

std::optional<Vec2> clear_position(const ConstructionRoom& room, const Vec2& size) {
  constexpr double step = 4;  // mm
  const Vec2 last = room.area.max - size;
  for (double y = room.area.min.y; y <= last.y; y += step)
    for (double x = room.area.min.x; x <= last.x; x += step) {
      const TurnedBox box = turned_box(Rectangle{{x, y}, Vec2(x, y) + size}.grown(apart));
      const auto touches = [&box](const TurnedBox& other) { return overlap(box, other); };
      if (std::none_of(room.taken.begin(), room.taken.end(), touches)) return Vec2(x, y);
    }
  return std::nullopt;
}

std::string distance_text(double millimetres) {
  // Up to three digits and zeros; scientific where nobody counts zeros.
  if (millimetres >= 1e9 && millimetres < 1e15) return format_fixed(std::round(millimetres / 1e9) * 1e3, 0) + " km";
  if (millimetres >= 1e6) return format_rounded(millimetres / 1e6, 3) + " km";
  if (millimetres >= 1e3) return format_rounded(millimetres / 1e3, 3) + " m";
  return format_rounded(millimetres, 3) + " mm";
}

double construction_room(const Figure& figure) { return figure.keys.empty() ? 0 : key_width + key_gap; }

Rectangle box_of(const Figure& figure, const Rectangle& ink, double farthest) {
  Rectangle box = ink;
  const Vec2 centre = ink.centre();
  const auto add = [&](const Vec2& p) {
    if (glm::length(p - centre) <= farthest) box = united(box, {p, p});
  };
  for (const construction::Point& point : figure.points) add(point.at);
  for (const construction::Line& one : figure.lines)
    if (one.extent == Extent::segment) {
      add(one.from);
      add(one.to);
    } else if (one.extent == Extent::line && !one.symbol.empty()) {
      // Of an endless line, what is nearest to the view.
      const Vec2 along = glm::normalize(one.to - one.from);
      add(one.from + glm::dot(centre - one.from, along) * along);
    }
  for (const construction::Curve& curve : figure.curves)
    for (const double angle : angles_of(curve)) add(on_curve(curve, angle));
  return box;
}

ConstructionLayer construction_layer(const std::string& view, const Figure& figure, const ConstructionRoom& room,
                                     const DimensionStyle& style) {
  const scene::SheetLine role = scene::SheetLine::construction;
  ConstructionLayer drawn{{view + "/" + scene::row_of(role).layer, line_style(role, {0, style.line}), {}}};
  Draughtsman hand(drawn.layer, room, style);
  hand.draw(figure);
  drawn.without_place = draw_keys(hand, figure, room);
  return drawn;
}

}  // namespace epura::sheet
