// SPDX-License-Identifier: Apache-2.0
#include "annotations/callouts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "dimensions/costs.hpp"
#include "drawing/drawing.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/furniture.hpp"
#include "sheet/line_styles.hpp"

namespace epura::sheet {

namespace {

constexpr double beside_text = 0.25, below = 0.5;     // free around texts on a reference line, in heights of capitals
constexpr double triangle = std::numbers::sqrt3 / 2;  // height of the triangle of a datum, likewise
constexpr double callout_clearance = 1.5;             // mm around a callout
constexpr double shortest_leader = 8, longest = 200, leader_step = 1.5;  // mm, of leaders

/// A direction of leaders, and how much it is disliked.
struct LeaderDirection {
  int degrees;
  double cost;
};

constexpr std::array<LeaderDirection, 16> oblique{{{60, 0},
                                                   {120, 0},
                                                   {45, 2.5},
                                                   {135, 2.5},
                                                   {300, 1},
                                                   {240, 1},
                                                   {315, 1.5},
                                                   {225, 1.5},
                                                   {30, 2},
                                                   {150, 2},
                                                   {75, 2.5},
                                                   {105, 2.5},
                                                   {330, 3},
                                                   {210, 3},
                                                   {285, 3.5},
                                                   {255, 3.5}}};

/// Others are for crowds; flatter and steeper ones look like lines of the drawing.
constexpr int flattest = 10, direction_step = 5;  // degrees
constexpr double for_other = 4;

/// A way of leaders to a callout, of any length.
struct Way {
  Vec2 tip, along;
  double cost = 0;
  std::optional<Vec2> via{};  ///< where it begins after a part along the normal
  bool to_right = false;      ///< the side of its end on which the callout is
  bool is_centred = false;    ///< otherwise the callout is above or below its end
  double landing = 0;         ///< mm
};

/// A place: the box of the callout, and its leader from the target.
struct Spot {
  Rectangle box;
  std::vector<Vec2> leader;
};

bool is_upright(const Vec2& direction) { return std::abs(direction.x) < 0.02; }
bool is_level(const Vec2& direction) { return std::abs(direction.y) < 0.02; }

// With a bend of the leader at a point.
Spot spot_at(const Callout& callout, const Way& way, const Vec2& bend) {
  const Vec2 &size = callout.size, out = {way.to_right ? 1 : -1, 0};
  const bool is_text = callout.form == LeaderForm::reference;
  const Vec2 end = bend + (is_text ? size.x : way.landing) * out;
  Vec2 corner = (is_text ? bend : end) - Vec2(way.to_right ? 0 : size.x, is_text ? 0 : callout.attach);
  if (way.is_centred) corner = bend - Vec2(size.x / 2, way.along.y > 0 ? 0 : size.y);
  Spot spot{{corner, corner + size}, {way.tip}};
  if (way.via) spot.leader.push_back(*way.via);
  spot.leader.push_back(bend);
  if (!way.is_centred) spot.leader.push_back(end);
  return spot;
}

/// Collects the ways to a callout from one target.
class Ways {
 public:
  Ways(const Callout& callout, const CalloutTarget& target, double text_height)
      : form_(callout.form), target_(target), text_height_(text_height) {}

  std::vector<Way> usual() && {
    const std::optional<Vec2>& normal = target_.normal;
    const bool is_text = form_ == LeaderForm::reference, is_datum = form_ == LeaderForm::datum;
    if (normal && !is_text) {
      add(*normal, 0);
      if (!target_.is_border) add(-*normal, 0);
    }
    if (normal && is_datum) add_bent_datums();
    if (normal && target_.in_line && !is_datum) add_bent_in_line();
    if ((is_datum && !target_.rim) || target_.in_line) return std::move(ways_);
    for (const LeaderDirection& direction : oblique) add_oblique(direction);
    check(!ways_.empty(), "frames and texts may be anywhere");
    return std::move(ways_);
  }
  std::vector<Way> in_crowd() && {
    if (form_ == LeaderForm::datum || target_.in_line) return {};
    for (int degrees = 0; degrees < 360; degrees += direction_step) {
      const int off_axis = std::min(degrees % 90, 90 - degrees % 90);
      if (off_axis >= flattest && std::ranges::find(oblique, degrees, &LeaderDirection::degrees) == oblique.end())
        add_oblique({degrees, for_other});
    }
    return std::move(ways_);
  }

 private:
  void add(const Vec2& along, double cost, const std::optional<Vec2>& via = std::nullopt) {
    const bool is_text = form_ == LeaderForm::reference;
    const double landing = is_level(along) && !is_text ? 0 : text_height_;
    const bool is_centred = form_ == LeaderForm::datum && !via && is_upright(along);
    const Vec2 tip = target_.rim ? target_.rim->towards(along) : target_.point;
    for (const bool to_right : {true, false})
      if (is_upright(along) ? to_right || !is_centred : to_right == (along.x > 0))
        ways_.push_back({tip, along, cost, via, to_right, is_centred, landing});
  }
  void add_oblique(const LeaderDirection& direction) {
    constexpr double for_inside = 12, for_oblique = 6;
    const std::optional<Vec2>& normal = target_.normal;
    const bool is_text = form_ == LeaderForm::reference;
    const Vec2 along = turned_to(direction.degrees * std::numbers::pi / 180);
    const double weight = is_text ? for_oblique : cost_of_slant;
    const double slant = normal ? weight * (1 - std::abs(glm::dot(along, *normal))) : 0;
    const bool is_inside = normal && target_.is_border && glm::dot(along, *normal) < 0.05;
    add(along, direction.cost + slant + (is_inside ? for_inside : 0) + (normal && !is_text ? for_oblique : 0));
  }
  // Where a perpendicular leader would cross lettering, that of a datum bends at the tip of its triangle.
  void add_bent_datums() {
    constexpr double for_bend = 10, min_rise = 0.2;  // of the direction, along the normal
    for (const double sign : {1.0, -1.0}) {
      if (sign < 0 && target_.is_border) continue;
      const Vec2 normal = sign * *target_.normal, tip = target_.point + triangle * text_height_ * normal;
      for (int degrees = 15; degrees < 360; degrees += 15) {
        const Vec2 along = turned_to(degrees * std::numbers::pi / 180);
        if (degrees % 90 != 0 && glm::dot(along, normal) >= min_rise) add(along, for_bend, tip);
      }
    }
  }
  // In line with a dimension line, then across it: where there is no other place.
  void add_bent_in_line() {
    const Vec2 elbow = target_.point + shortest_leader * *target_.normal;
    for (const double side : {1.0, -1.0}) add(side * left_of(*target_.normal), cost_of_letter, elbow);
  }

  LeaderForm form_;
  const CalloutTarget& target_;
  double text_height_;
  std::vector<Way> ways_{};
};

// What it takes up on paper: the strokes are its leader and the outline of its box. The leader may touch what it means,
// and in line with a dimension line it begins beside the arrow of that.
PlacedDimension drawn(const Spot& spot, const Callout& callout, const CalloutTarget& target) {
  constexpr double at_target = 0.5;  // mm
  PlacedDimension placed;
  placed.strokes = {Stroke{spot.leader}, outline(spot.box)};
  placed.zones = {turned_box(spot.box.grown(callout_clearance))};
  placed.text_boxes = placed.zones;
  const std::size_t lines = spot.leader.size() - (callout.form == LeaderForm::reference ? 1 : 0);
  for (std::size_t i = 1; i < lines; ++i) {
    const Vec2 &from = spot.leader[i - 1], &to = spot.leader[i];
    const double length = glm::distance(from, to), free = i > 1 ? 0 : target.in_line ? shortest_leader : at_target;
    if (length <= free) continue;
    placed.leaders.push_back({from + free / length * (to - from), to, free});
    placed.lines.push_back(line_box(placed.leaders.back().tip, to));
  }
  return placed;
}

Rectangle box_of(const PlacedDimension& placed) {
  const std::vector<Vec2>& outline = placed.strokes.back().points;
  return {outline[0], outline[2]};
}

// The way from its target to a box in which it stands, from the left or right.
Way way_to(const Rectangle& box, bool to_right, const Callout& callout, double landing) {
  const CalloutTarget& target = *callout.target;
  const bool is_text = callout.form == LeaderForm::reference;
  const double away = is_text ? 0 : landing;
  const Vec2 bend(to_right ? box.min.x - away : box.max.x + away, box.min.y + (is_text ? 0 : callout.attach));
  const Vec2 tip = target.rim ? target.rim->towards(glm::normalize(bend - target.rim->centre)) : target.point;
  return {tip, bend - tip, 0, std::nullopt, to_right, false, landing};
}

// In a box, from the side whose leader does not cross the callout, or the nearer one.
struct SpotInBox {
  Spot spot;
  bool crosses;  ///< whether the leader does
  double length;
};
SpotInBox spot_in(const Rectangle& box, const Callout& callout, double landing) {
  const auto from = [&](bool to_right) {
    const Way way = way_to(box, to_right, callout, landing);
    const Spot spot = spot_at(callout, way, way.tip + way.along);
    return SpotInBox{spot, overlap(line_box(spot.leader[0], spot.leader[1]), turned_box(box)), glm::length(way.along)};
  };
  const auto rank = [](const SpotInBox& one) { return std::pair(one.crosses, one.length); };
  const SpotInBox right = from(true), left = from(false);
  return rank(left) < rank(right) ? left : right;
}

// Ends of a dimension line, with which a callout is in line. Where arrows are outside, one makes room.
std::vector<CalloutTarget> targets_at(std::vector<DimensionEnd> ends, const Callout& callout) {
  std::stable_sort(ends.begin(), ends.end(),
                   [](const auto& a, const auto& b) { return !a.arrow.has_value() && b.arrow.has_value(); });
  std::vector<CalloutTarget> targets;
  for (std::size_t i = callout.end; i < ends.size(); ++i)
    if (i == callout.end || (callout.is_alone && i == 1 && !ends[1].arrow))
      targets.push_back({ends[i].point, LeaderEnd::arrow, ends[i].outwards, true, true});
  return targets;
}

std::vector<CalloutTarget> targets_of(const Callout& callout, const std::vector<DimensionEnd>& ends) {
  if (!callout.target) return targets_at(ends, callout);
  std::vector<CalloutTarget> targets{*callout.target};
  targets.insert(targets.end(), callout.others.begin(), callout.others.end());
  return targets;
}

// Not on hatching, and outside the view if possible.
std::vector<ItemPlacement> placements_of(const Callout& callout, const std::vector<CalloutTarget>& targets,
                                         std::vector<Way> (Ways::*ways)() &&, const drawing::ViewDrawing& view,
                                         const DimensionStyle& style) {
  const std::vector<Rectangle> hatched = hatched_boxes(view);
  const Rectangle whole{view.box.min, view.box.max};
  std::vector<ItemPlacement> placements;
  std::size_t number = 0;
  for (const CalloutTarget& target : targets)
    for (const Way& way : (Ways(callout, target, style.text).*ways)()) {
      for (double length = shortest_leader; length <= longest; length += leader_step) {
        const Vec2 bend = way.via.value_or(way.tip) + length * way.along;
        const Rectangle box = spot_at(callout, way, bend).box;
        const auto is_on = [&](const Rectangle& one) { return one.overlaps(box.grown(callout_clearance)); };
        if (std::any_of(hatched.begin(), hatched.end(), is_on)) continue;
        const double cost = way.cost + cost_of_way * length + (box.overlaps(whole) ? cost_in_view : 0);
        check(cost >= 0, "a longer leader is no better");
        placements.push_back(
            {[=, &callout] { return drawn(spot_at(callout, way, bend), callout, target); }, cost, number});
      }
      ++number;
    }
  return placements;
}

// Where another one stands, at the side of that box on which its target is.
std::optional<ItemPlacement> placement_instead(const Callout& callout, const PlacedDimension& other,
                                               const drawing::ViewDrawing& view, const DimensionStyle& style) {
  const Rectangle there = box_of(other);
  const bool at_left = callout.target->point.x < there.centre().x;
  const Vec2 corner(at_left ? there.min.x : there.max.x - callout.size.x, there.min.y);
  const Rectangle box{corner, corner + callout.size};
  const SpotInBox in_box = spot_in(box, callout, style.text);
  if (in_box.crosses) return std::nullopt;
  const double cost =
      for_other + cost_of_way * in_box.length + (box.overlaps({view.box.min, view.box.max}) ? cost_in_view : 0);
  return ItemPlacement(drawn(in_box.spot, callout, *callout.target), cost);
}

// A triangle on a line, on the side of its leader. ISO 5459.
Fill datum_triangle(const Vec2& tip, const std::optional<Vec2>& line_normal, const Vec2& leader,
                    const DimensionStyle& style) {
  const Vec2 normal = line_normal.value_or(leader);
  const Vec2 along = glm::dot(normal, leader) < 0 ? -normal : normal;
  const Vec2 across = style.text / 2 * left_of(along);
  return {{{tip + across, tip - across, tip + triangle * style.text * along}}};
}

// Before the callout is drawn. A callout without lines of its own is a text; its leader has it.
LeaderObject leader_object(const Layer& notes, const Callout& callout, const Rectangle& box, LeaderEnd end,
                           const DimensionStyle& style) {
  LeaderObject object{notes.strokes.back().points, end, style.arrow()};
  const std::size_t texts = notes.texts.size();
  const bool is_text = callout.form == LeaderForm::reference && callout.strokes.empty() && callout.fills.empty();
  object.texts = {texts, texts + (is_text ? callout.texts.size() : 0)};
  if (!is_text) return object;
  for (const Text& text : callout.texts) object.lines.push_back(text.text);
  object.text_corner = {box.min.x, box.max.y};
  object.text_height = style.text;
  return object;
}

void draw_callout(CalloutLayers& layers, const Callout& callout, const CalloutTarget& target,
                  const PlacedDimension& placed, const DimensionStyle& style) {
  const Rectangle box = box_of(placed);
  const std::vector<Vec2>& way = placed.strokes.front().points;
  const std::size_t fills = layers.notes.fills.size();
  const Vec2 &tip = way.front(), along = glm::normalize(way[1] - tip);
  Stroke& leader = layers.notes.strokes.emplace_back();
  for (const Vec2& p : way)
    if (leader.points.empty() || leader.points.back() != p) leader.points.push_back(p);
  check(!leader.points.empty(), "a leader begins at its target");
  constexpr double around = 0.5;  // heights of capitals. ISO 1101
  if (callout.all_around) layers.symbols.strokes.push_back(circle_at(way[1], around * style.text));
  if (callout.form == LeaderForm::datum)
    layers.notes.fills.push_back(datum_triangle(tip, target.normal, along, style));
  else if (target.end == LeaderEnd::arrow)
    layers.notes.fills.push_back(arrow_at(tip, -along, style));
  else if (target.end == LeaderEnd::dot)
    layers.notes.fills.push_back(dot_at(tip));
  if (callout.form != LeaderForm::datum) {
    LeaderObject object = leader_object(layers.notes, callout, box, target.end, style);
    object.strokes = {layers.notes.strokes.size() - 1, layers.notes.strokes.size()};
    object.fills = {fills, layers.notes.fills.size()};
    layers.notes.leaders.push_back(std::move(object));
  }
  draw_at(layers, callout, {box.min.x, box.max.y});
}

// Lines of at most `width`, broken at blanks; further lines are indented like the first one.
std::vector<std::string> wrapped(const std::string& text, double width, const DimensionStyle& style) {
  const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
  std::vector<std::string> lines;
  std::string rest = text;
  while (style.lettering.width(rest, style.text) > width) {
    std::size_t end = std::string::npos;
    for (std::size_t blank = rest.find(' ', indent); blank != std::string::npos; blank = rest.find(' ', blank + 1)) {
      if (end != std::string::npos && style.lettering.width(rest.substr(0, blank), style.text) > width) break;
      end = blank;
    }
    if (end == std::string::npos) break;
    lines.push_back(rest.substr(0, end));
    rest = std::string(indent, ' ') + rest.substr(std::min(rest.find_first_not_of(' ', end), rest.size()));
  }
  lines.push_back(rest);
  return lines;
}

/// Sets lines below each other; the first base line is one height below the origin.
class LineSetter {
 public:
  LineSetter(Callout& callout, const DimensionStyle& style) : callout_(callout), style_(style) {}

  void set(const std::string& line, double left) {
    if (!line.empty()) callout_.texts.push_back({line, {left, base_}, style_.text, 0, Align::left, "note"});
    callout_.size.x = std::max(callout_.size.x, left + style_.lettering.width(line, style_.text));
  }
  void next_line(double lines = 1) { base_ -= lines * line_spacing * style_.text; }

  // Puts the lower left corner at the origin, with this much below the last base line.
  void finish(double descent) {
    callout_.size.y = descent - base_;
    for (Text& text : callout_.texts) text.at.y += callout_.size.y;
  }

 private:
  Callout& callout_;
  const DimensionStyle& style_;
  double base_ = -style_.text;
};

}  // namespace

Callout note_callout(const std::vector<std::string>& lines, bool has_leader, const DimensionStyle& style) {
  Callout callout{lines.front()};
  const double left = has_leader ? beside_text * style.text : 0;
  LineSetter setter(callout, style);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) setter.next_line();
    setter.set(lines[i], left);
  }
  setter.finish(has_leader ? below * style.text : 0);
  callout.size.x += left;
  return callout;
}

Callout general_notes(const std::string& heading, std::span<const std::vector<std::string>> notes, double width,
                      const DimensionStyle& style) {
  Callout callout{heading};
  LineSetter setter(callout, style);
  setter.set(heading, 0);
  const double indent =
      style.lettering.width(std::to_string(notes.size()) + ". ", style.text) + beside_text * style.text;
  for (std::size_t i = 0; i < notes.size(); ++i) {
    setter.next_line(i == 0 ? 1.3 : 1);
    setter.set(std::to_string(i + 1) + ".", 0);
    bool is_first = true;
    for (const std::string& line : notes[i])
      for (const std::string& part : wrapped(line, width - indent, style)) {
        if (!std::exchange(is_first, false)) setter.next_line();
        setter.set(part, indent);
      }
  }
  setter.finish(below * style.text);
  return callout;
}

Rectangle box_at(const Callout& callout, const Vec2& upper_left) {
  return {upper_left - Vec2(0, callout.size.y), upper_left + Vec2(callout.size.x, 0)};
}

void draw_at(CalloutLayers& layers, const Callout& callout, const Vec2& upper_left) {
  const Vec2 corner = box_at(callout, upper_left).min;
  const auto after = [](const InkRange& range, std::size_t before) {
    return InkRange{before + range.begin, before + range.end};
  };
  for (const ToleranceObject& tolerance : callout.tolerances) {
    layers.notes.tolerances.push_back({tolerance.rows, corner + tolerance.at, tolerance.text_height});
    layers.notes.tolerances.back().texts = after(tolerance.texts, layers.notes.texts.size());
    layers.symbols.tolerances.emplace_back();
    layers.symbols.tolerances.back().strokes = after(tolerance.strokes, layers.symbols.strokes.size());
    layers.symbols.tolerances.back().fills = after(tolerance.fills, layers.symbols.fills.size());
  }
  for (Text text : callout.texts) {
    text.at += corner;
    layers.notes.texts.push_back(std::move(text));
  }
  check(layers.notes.texts.size() >= callout.texts.size(), "all texts of a callout are drawn");
  for (Stroke stroke : callout.strokes) {
    for (Vec2& p : stroke.points) p += corner;
    for (drawing::CurvePart& curve : stroke.curves) curve.centre += corner;
    layers.symbols.strokes.push_back(std::move(stroke));
  }
  for (Fill fill : callout.fills) {
    for (std::vector<Vec2>& ring : fill.rings)
      for (Vec2& p : ring) p += corner;
    layers.symbols.fills.push_back(std::move(fill));
  }
}

CalloutLayers callout_layers(const std::string& view, const DimensionStyle& style) {
  constexpr double letters = 10;  // heights of capitals in line widths. ISO 3098-1, type B
  CalloutLayers layers{empty_layer(view, scene::SheetLine::note, {2 * style.line, style.line}),
                       empty_layer(view, scene::SheetLine::symbol, {2 * style.line, style.line})};
  layers.symbols.style.width = style.text / letters;
  return layers;
}

std::vector<Rectangle> hatched_boxes(const drawing::ViewDrawing& drawing) {
  std::vector<Rectangle> boxes;
  for (const drawing::CutFace& face : drawing.cuts.faces)
    for (const std::vector<Vec2>& ring : face.rings) {
      Rectangle& box = boxes.emplace_back(Rectangle{ring.front(), ring.front()});
      for (const Vec2& p : ring) box = united(box, {p, p});
    }
  return boxes;
}

double inside_by(const Vec2& point, const drawing::ViewDrawing& view) {
  const Vec2 inside = glm::min(point - view.box.min, view.box.max - point);
  return std::min(inside.x, inside.y);
}

double callout_room(double height) { return shortest_leader + height + callout_clearance; }

namespace {

// Those with the least choice first.
std::array<double, 2> order_of(const Callout& callout) {
  constexpr std::array<LeaderForm, 3> forms{LeaderForm::datum, LeaderForm::landing, LeaderForm::reference};
  return {callout.at ? 0.0 : 2.0, static_cast<double>(std::ranges::find(forms, callout.form) - forms.begin())};
}

}  // namespace

std::vector<ItemBeside> callout_items(std::span<const Callout> callouts, const drawing::ViewDrawing& view,
                                      const DimensionStyle& style) {
  std::vector<ItemBeside> items;
  for (const Callout& callout : callouts) {
    PlacementItem item;
    item.usual = [&](const PlacedDimension* host) {
      if (callout.at)
        return std::vector<ItemPlacement>{
            {drawn(spot_in(box_at(callout, *callout.at), callout, style.text).spot, callout, *callout.target), 0}};
      return placements_of(callout, targets_of(callout, host ? host->ends : std::vector<DimensionEnd>()), &Ways::usual,
                           view, style);
    };
    if (callout.target && !callout.at && callout.others.empty() && callout.form != LeaderForm::datum)
      item.instead = [&](const PlacedDimension& other) { return placement_instead(callout, other, view, style); };
    if (callout.target && !callout.at)
      item.in_crowd = [&](const PlacedDimension*) {
        return placements_of(callout, targets_of(callout, {}), &Ways::in_crowd, view, style);
      };
    const auto [given, form] = order_of(callout);
    const bool is_text = callout.form == LeaderForm::reference;  // many stand close to each other
    item.order = {given, form, is_text && callout.target ? inside_by(callout.target->point, view) : 0};
    item.rank = callout.at ? ItemRank::drawn : ItemRank::required;
    item.is_clear = !callout.at;
    if (callout.target && callout.others.empty())
      item.like = {callout.target->point.x, callout.target->point.y, callout.attach, item.order[1]};
    item.size = callout.size;
    items.push_back({std::move(item), callout.dimension});
  }
  check(items.size() == callouts.size(), "every callout is an item");
  return items;
}

void take_out_replaced(PlacedLayer& placed, std::span<const Callout> callouts) {
  std::vector<int> replaced;
  for (std::size_t i = 0; i < callouts.size(); ++i) {
    if (callouts[i].target || !placed.beside[i]) continue;
    for (const DimensionEnd& end : placed.ends[callouts[i].dimension])
      if (end.arrow && end.point == placed.beside[i]->strokes.front().points.front()) replaced.push_back(*end.arrow);
  }
  std::sort(replaced.rbegin(), replaced.rend());
  for (const int arrow : replaced) placed.layer.fills.erase(placed.layer.fills.begin() + arrow);
}

CalloutFaults draw_callouts(CalloutLayers& layers, std::span<const Callout> callouts, const PlacedLayer& placed,
                            const DimensionStyle& style) {
  CalloutFaults faults;
  std::vector<std::size_t> order(callouts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return order_of(callouts[i]); });
  for (const std::size_t i : order) {
    const Callout& callout = callouts[i];
    const std::optional<PlacedDimension>& one = placed.beside[i];
    if (!one) {
      faults.without_place.push_back(i);
      continue;
    }
    const auto host = placed.ends.find(callout.dimension);
    const std::vector<CalloutTarget> targets =
        targets_of(callout, host != placed.ends.end() ? host->second : std::vector<DimensionEnd>());
    const Vec2& tip = one->strokes.front().points.front();
    const auto target = std::ranges::find_if(
        targets, [&tip](const CalloutTarget& of) { return of.rim.has_value() || of.point == tip; });
    check(target != targets.end(), "a leader begins at its target");
    draw_callout(layers, callout, *target, *one, style);
    faults.places.emplace_back(i, turned_box(box_of(*one)));
  }
  return faults;
}

}  // namespace epura::sheet
