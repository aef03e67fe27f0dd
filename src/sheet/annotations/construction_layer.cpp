// SPDX-License-Identifier: Apache-2.0
#include "annotations/construction_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "annotations/label_places.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "sheet/free_rectangles.hpp"
#include "sheet/furniture.hpp"
#include "sheet/line_styles.hpp"

namespace epura::sheet {

namespace {

using construction::Extent;
using construction::Figure;
using construction::Symbol;

constexpr double mark_radius = 0.7;                                       // mm, of the circle around a point
constexpr double index_height = 0.7, index_drop = 0.3, descender = 0.27;  // of the height of the symbol
constexpr double row_step = 1.6;                                          // likewise, from one base line to the next
constexpr double leader_gap = 0.6;                                        // mm between a leader and its label
constexpr double arrow_shaft = 9;                                         // mm
constexpr int parts_of_circle = 180;
constexpr double key_width = 78, key_gap = 8;  // mm: room for figures of constant size

/// A symbol as texts, the left end of its base line at the origin.
struct Lettered {
  std::vector<Text> texts{};
  Vec2 size{0, 0};
  double drop = 0;  ///< of indices and letters below the base line
};

// Whether a letter reaches below the base line.
bool descends(std::string_view text) {
  constexpr std::array letters{"g", "j", "p", "q", "y", ",", ";", "(", ")", "Q", "β", "γ"};
  return std::any_of(letters.begin(), letters.end(),
                     [text](const char* letter) { return text.find(letter) != std::string_view::npos; });
}

void add_construction_symbol(Lettered& lettered, const Symbol& symbol, const DimensionStyle& style) {
  const auto add = [&](const std::string& text, double height, double drop) {
    if (text.empty()) return;
    lettered.texts.push_back({text, {lettered.size.x, -drop}, height, 0, Align::left, "construction"});
    lettered.size.x += style.lettering.width(text, height);
    lettered.drop = std::max(lettered.drop, drop + (descends(text) ? descender * height : 0));
  };
  add(symbol.base, style.text, 0);
  add(symbol.index, index_height * style.text, index_drop * style.text);
  lettered.size.y = style.text;
}

Lettered lettered(const Symbol& symbol, const std::vector<Symbol>& also, const std::string& rest,
                  const DimensionStyle& style) {
  Lettered all;
  add_construction_symbol(all, symbol, style);
  for (const Symbol& other : also) {
    add_construction_symbol(all, {"≡"}, style);
    add_construction_symbol(all, other, style);
  }
  if (!rest.empty()) add_construction_symbol(all, {" " + rest}, style);
  return all;
}

// Rows below each other, on the base line of the last.
Lettered stacked(const std::vector<Lettered>& rows, const DimensionStyle& style) {
  Lettered all;
  double rise = row_step * style.text * static_cast<double>(rows.size() - 1);
  all.size.y = rise + style.text;
  for (const Lettered& row : rows) {
    for (Text text : row.texts) {
      text.at.y += rise;
      all.texts.push_back(std::move(text));
    }
    all.size.x = std::max(all.size.x, row.size.x);
    all.drop = row.drop;
    rise -= row_step * style.text;
  }
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

bool is_closed(const construction::Curve& curve) { return curve.to - curve.from > 2 * std::numbers::pi - 1e-9; }

/// What is beyond the room, in one direction: its arrow on the border, and a row for each thing there.
struct Beyond {
  struct Row {
    double distance;
    Symbol symbol;
    std::vector<Symbol> also;
  };
  Vec2 tip, tail;
  std::vector<Row> rows{};
};

/// The ink of a figure.
struct Ink {
  std::vector<Stroke> strokes{};
  std::vector<Fill> fills{};
  std::vector<Text> texts{};
  std::vector<std::string> unnamed{};  ///< symbols without a place
};

/// Draws a figure: first lines, marks and arrows, then the symbols among them.
class Draughtsman {
 public:
  Draughtsman(const ConstructionRoom& room, const DimensionStyle& style)
      : room_(room), style_(style), space_(room.labels.value_or(room.area)) {
    for (const TurnedBox& box : room.taken) space_.add_lettering(box);
    for (const drawing::ViewDrawing* view : room.views)
      for (const drawing::Segment& segment : view->segments) space_.add_line(segment.from, segment.to);
  }

  Ink drawn(const Figure& figure);

 private:
  using Parts = std::vector<std::vector<double>>;  // of a curve: angles

  void add_line(const Vec2& from, const Vec2& to);
  [[nodiscard]] Parts parts_inside(const construction::Curve& curve) const;
  void draw_lines(const Figure& figure);
  void draw_curves(const Figure& figure);
  void draw_points(const Figure& figure);
  void add_arc(const construction::Curve& curve, const std::vector<double>& angles);
  void mark(const Vec2& at);
  void point_to(const construction::Point& point);
  void draw_arrows();
  void name(Lettered symbol, Label label);
  void name_line(const construction::Line& line, const std::array<Vec2, 2>& part);
  void name_curve(const construction::Curve& curve, const Parts& parts);
  void name_curves(const Figure& figure, bool closed);
  void name_point(const construction::Point& point, const Vec2& at);
  void place_names();
  [[nodiscard]] bool is_inside(const Vec2& p) const { return room_.area.holds({p, p}); }
  [[nodiscard]] Vec2 exit_towards(const construction::Point& point) const;

  const ConstructionRoom& room_;
  const DimensionStyle& style_;
  LabelRoom space_;
  Ink ink_{};
  std::vector<Parts> parts_{};  // of each curve
  std::vector<Beyond> beyond_{};
  std::vector<Lettered> names_{};
  std::vector<Label> labels_{};  // of these names
};

void Draughtsman::add_line(const Vec2& from, const Vec2& to) {
  ink_.strokes.push_back(line(from, to));
  space_.add_line(from, to);
}

// The parts of a curve that are in the room.
Draughtsman::Parts Draughtsman::parts_inside(const construction::Curve& curve) const {
  const auto is_there = [&](double angle) { return is_inside(on_curve(curve, angle)); };
  // Between an angle inside and one outside.
  const auto border = [&](double inside, double outside) {
    constexpr int halvings = 50;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (inside + outside) / 2;
      (is_there(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  const std::vector<double> angles = angles_of(curve);
  Parts parts;
  std::vector<double> part;
  const auto finish = [&] {
    check(std::is_sorted(part.begin(), part.end()), "a part of a curve goes forwards");
    if (part.size() > 1) parts.push_back(part);
    part.clear();
  };
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const bool inside = is_there(angles[i]);
    if (inside && part.empty() && i > 0) part.push_back(border(angles[i], angles[i - 1]));
    if (inside) part.push_back(angles[i]);
    if (inside || part.empty()) continue;
    part.push_back(border(part.back(), angles[i]));
    finish();
  }
  finish();
  return parts;
}

void Draughtsman::add_arc(const construction::Curve& curve, const std::vector<double>& angles) {
  Stroke stroke;
  for (const double angle : angles) stroke.points.push_back(on_curve(curve, angle));
  for (std::size_t i = 1; i < stroke.points.size(); ++i) space_.add_line(stroke.points[i - 1], stroke.points[i]);
  stroke.curves = {
      {0, static_cast<int>(angles.size()) - 1, curve.centre, curve.u, curve.v, angles.front(), angles.back()}};
  if (angles.back() - angles.front() > 2 * std::numbers::pi - 1e-9) {
    stroke.closed = true;
    stroke.points.pop_back();
  }
  ink_.strokes.push_back(std::move(stroke));
}

void Draughtsman::mark(const Vec2& at) {
  ink_.strokes.push_back(circle_at(at, mark_radius));
  space_.add_mark(turned_box({at - mark_radius, at + mark_radius}));
}

void Draughtsman::name(Lettered symbol, Label label) {
  label.size = symbol.size + Vec2(0, symbol.drop);
  names_.push_back(std::move(symbol));
  labels_.push_back(std::move(label));
}

// Endless lines are named near their ends.
void Draughtsman::name_line(const construction::Line& line, const std::array<Vec2, 2>& part) {
  constexpr std::array ends{0.03, 0.97, 0.1, 0.9, 0.2, 0.8, 0.3, 0.7, 0.5};
  constexpr std::array middle{0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9};
  Label label{};
  for (const double t : line.extent == Extent::segment ? middle : ends)
    label.anchors.push_back({part[0] + t * (part[1] - part[0])});
  name(lettered(line.symbol, {}, "", style_), std::move(label));
}

// On the outer side, where the parts of the curve are longest.
void Draughtsman::name_curve(const construction::Curve& curve, const Parts& parts) {
  constexpr std::array all_around{0.5, 0.125, 0.375, 0.875, 0.625, 0.05, 0.2, 0.3, 0.45, 0.55, 0.7, 0.8, 0.95};
  constexpr std::array middle{0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8};
  Label label{};
  Parts ordered = parts;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.back() - a.front() > b.back() - b.front(); });
  for (const std::vector<double>& part : ordered)
    for (const double t : is_closed(curve) ? std::span<const double>(all_around) : std::span<const double>(middle)) {
      const Vec2 at = on_curve(curve, part.front() + t * (part.back() - part.front()));
      label.anchors.push_back({at, glm::normalize(at - curve.centre)});
    }
  name(lettered(curve.symbol, {}, "", style_), std::move(label));
}

void Draughtsman::name_curves(const Figure& figure, bool closed) {
  for (std::size_t i = 0; i < figure.curves.size(); ++i)
    if (const construction::Curve& curve = figure.curves[i];
        !curve.symbol.empty() && is_closed(curve) == closed && !parts_[i].empty())
      name_curve(curve, parts_[i]);
}

// Without a mark, it names what is around the point, or the end of a line that comes from its guide.
void Draughtsman::name_point(const construction::Point& point, const Vec2& at) {
  Label label{};
  const bool has_direction = !point.marked && point.guide != point.at;
  label.anchors.push_back({at, has_direction ? glm::normalize(point.at - point.guide) : Vec2(0, 0)});
  label.from = point.marked ? mark_radius : 0;
  label.inside = !point.marked && !has_direction;
  name(lettered(point.symbol, point.also, "", style_), std::move(label));
}

// Where the line from its guide, or from the middle of the room, leaves the room.
Vec2 Draughtsman::exit_towards(const construction::Point& point) const {
  const bool has_guide = is_inside(point.guide) && point.guide != point.at;
  const Vec2 from = has_guide ? point.guide : room_.area.centre();
  const auto part = clipped({from, point.at}, room_.area);
  return part ? (*part)[1] : from;
}

// What lies in one direction has one arrow.
void Draughtsman::point_to(const construction::Point& point) {
  constexpr double same = 0.5;  // mm
  const Vec2 tip = exit_towards(point), away = point.at - tip;
  auto found = std::find_if(beyond_.begin(), beyond_.end(),
                            [&tip](const Beyond& other) { return glm::length(other.tip - tip) < same; });
  if (found == beyond_.end()) found = beyond_.insert(found, {tip, tip - arrow_shaft * glm::normalize(away)});
  found->rows.push_back({glm::length(away), point.symbol, point.also});
}

void Draughtsman::draw_arrows() {
  for (Beyond& beyond : beyond_) {
    check(beyond.tip != beyond.tail && !beyond.rows.empty(), "an arrow points to what is beyond the room");
    const Vec2 direction = glm::normalize(beyond.tip - beyond.tail), foot = beyond.tip - style_.arrow() * direction;
    add_line(beyond.tail, foot);
    ink_.fills.push_back(arrow_at(beyond.tip, direction, style_));
    TurnedBox head = line_box(foot, beyond.tip);
    head.half.y = glm::length(ink_.fills.back().rings[0][1] - foot);
    space_.add_mark(head);
    std::stable_sort(beyond.rows.begin(), beyond.rows.end(),
                     [](const Beyond::Row& a, const Beyond::Row& b) { return a.distance < b.distance; });
    std::vector<Lettered> rows;
    for (const Beyond::Row& row : beyond.rows)
      rows.push_back(lettered(row.symbol, row.also, distance_text(row.distance), style_));
    Label label{};
    label.anchors = {{(beyond.tail + foot) / 2.0}, {beyond.tail}};
    name(stacked(rows, style_), std::move(label));
  }
}

void Draughtsman::draw_lines(const Figure& figure) {
  for (const construction::Line& one : figure.lines) {
    const auto part = clipped(one, room_.area);
    if (part) add_line((*part)[0], (*part)[1]);
    if (part || one.symbol.empty() || one.extent != Extent::line) continue;
    const Vec2 middle = room_.area.centre(), along = glm::normalize(one.to - one.from);
    point_to({one.symbol, one.from + glm::dot(middle - one.from, along) * along, middle});
  }
}

void Draughtsman::draw_curves(const Figure& figure) {
  for (const construction::Curve& curve : figure.curves) {
    const Parts& parts = parts_.emplace_back(parts_inside(curve));
    for (const std::vector<double>& part : parts) add_arc(curve, part);
    if (curve.symbol.empty() || !parts.empty()) continue;
    const Vec2 middle = room_.area.centre();
    Vec2 nearest = on_curve(curve, curve.from);
    for (const double angle : angles_of(curve))
      if (const Vec2 p = on_curve(curve, angle); glm::length(p - middle) < glm::length(nearest - middle)) nearest = p;
    point_to({curve.symbol, nearest, middle});
  }
}

// A point that stands for the end of a line on the sheet is where this line ends.
void Draughtsman::draw_points(const Figure& figure) {
  for (const construction::Point& point : figure.points) {
    if (is_inside(point.at)) {
      if (point.marked) mark(point.at);
      name_point(point, point.at);
    } else if (!point.on_sheet) {
      point_to(point);
    } else if (const auto part = clipped({point.guide, point.at}, room_.area); part && !point.marked) {
      name_point(point, (*part)[1]);
    } else {
      ink_.unnamed.push_back(point.symbol.text());
    }
  }
}

void Draughtsman::place_names() {
  const std::vector<std::optional<LabelPlace>> places = space_.place(labels_);
  check(places.size() == names_.size(), "every name has a label");
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::string all;
    for (const Text& text : names_[i].texts) all += text.text;
    if (!places[i]) {
      ink_.unnamed.push_back(std::move(all));
      continue;
    }
    const LabelPlace& place = *places[i];
    if (place.has_leader) {
      const Vec2 end = place.tie[1] + leader_gap * glm::normalize(place.tie[0] - place.tie[1]);
      ink_.strokes.push_back(line(place.tie[0], end));
      if (labels_[i].inside && !place.is_on_line) ink_.fills.push_back(dot_at(place.anchor));
    }
    for (Text& text : names_[i].texts) {
      text.at += place.box.min + Vec2(0, names_[i].drop);
      ink_.texts.push_back(std::move(text));
    }
  }
}

// Names that can stand in few places come first: in the corner of an angle, at an arrow, at a point.
Ink Draughtsman::drawn(const Figure& figure) {
  draw_lines(figure);
  draw_curves(figure);
  name_curves(figure, false);
  draw_points(figure);
  draw_arrows();
  for (const construction::Line& one : figure.lines)
    if (const auto part = clipped(one, room_.area); part && !one.symbol.empty()) name_line(one, *part);
  name_curves(figure, true);
  place_names();
  return std::move(ink_);
}

void move_by(Ink& ink, const Vec2& by) {
  for (Stroke& stroke : ink.strokes) {
    for (Vec2& p : stroke.points) p += by;
    for (drawing::CurvePart& curve : stroke.curves) curve.centre += by;
  }
  for (Fill& fill : ink.fills)
    for (std::vector<Vec2>& ring : fill.rings)
      for (Vec2& p : ring) p += by;
  for (Text& text : ink.texts) text.at += by;
}

void add(ConstructionLayer& drawn, Ink ink) {
  append(drawn.layer.strokes, std::move(ink.strokes));
  append(drawn.layer.fills, std::move(ink.fills));
  append(drawn.layer.texts, std::move(ink.texts));
  append(drawn.unnamed, std::move(ink.unnamed));
}

std::optional<Rectangle> box_with_ink(const Layer& layer, const Lettering& lettering) {
  std::optional<Rectangle> all;
  for (const TurnedBox& box : boxes_of(layer, lettering)) all = all ? united(*all, around(box)) : around(box);
  return all;
}

// Figures of their own: below each other on the left of the view, or where there is room.
void add_keys(ConstructionLayer& drawn, const Figure& figure, const ConstructionRoom& room,
              const DimensionStyle& style) {
  constexpr double unlimited = 500;  // mm
  const ConstructionRoom empty{{Vec2(-unlimited), Vec2(unlimited)}};
  std::vector<Rectangle> taken;
  Rectangle ink{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const drawing::ViewDrawing* view : room.views) {
    ink = united(ink, {view->box.min, view->box.max});
    taken.push_back({view->box.min, view->box.max});
  }
  for (const TurnedBox& box : room.taken) taken.push_back(around(box));
  for (const TurnedBox& box : boxes_of(drawn.layer, style.lettering)) taken.push_back(around(box));
  std::optional<Rectangle> above;
  for (const Figure& key : figure.keys) {
    Ink own = Draughtsman(empty, style).drawn(key);
    const Layer alone{{}, drawn.layer.style, own.strokes, own.fills, own.texts};
    Rectangle box = *box_with_ink(alone, style.lettering);
    box.min.y -= descender * style.text;
    const Vec2 half = box.size() / 2.0;
    const Vec2 towards = above ? Vec2(above->centre().x, above->min.y - key_gap - half.y)
                               : Vec2(ink.min.x - half.x - key_gap, ink.max.y - half.y);
    const auto corner = nearest_free_position(room.area, taken, box.size(), towards);
    if (!corner) {
      ++drawn.without_place;
      continue;
    }
    move_by(own, *corner - box.min);
    add(drawn, std::move(own));
    above = Rectangle{*corner, *corner + box.size()};
    check(room.area.holds(*above, 1e-6), "a key is on the paper");
    taken.push_back(*above);
    drawn.keys.push_back(*above);
  }
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
  check((line.extent == Extent::line || from >= 0) && (line.extent != Extent::segment || to <= length),
        "what is clipped is a part of the line");
  const Vec2 end = line.extent == Extent::segment && to == length ? line.to : line.from + to * direction;
  return std::array<Vec2, 2>{from == 0 ? line.from : line.from + from * direction, end};
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
  check(box.holds(ink), "a box contains the ink it is made for");
  return box;
}

ConstructionLayer construction_layer(const std::string& view, const Figure& figure, const ConstructionRoom& room,
                                     const DimensionStyle& style) {
  const scene::SheetLine role = scene::SheetLine::construction;
  ConstructionLayer drawn{{view + "/" + scene::row_of(role).layer, line_style(role, {0, style.line}), {}}};
  add(drawn, Draughtsman(room, style).drawn(figure));
  add_keys(drawn, figure, room, style);
  return drawn;
}

}  // namespace epura::sheet
