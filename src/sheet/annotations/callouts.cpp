// SPDX-License-Identifier: Apache-2.0
#include "annotations/callouts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "dimensions/surroundings.hpp"
#include "drawing/drawing.hpp"
#include "sheet/box_index.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/line_styles.hpp"

namespace epura::sheet {

namespace {

constexpr double beside_text = 0.25, below = 0.5;     // free around texts on a reference line, in heights of capitals
constexpr double triangle = std::numbers::sqrt3 / 2;  // height of the triangle of a datum, likewise
constexpr double callout_clearance = 1.5;             // mm, between a callout and everything else
constexpr double shortest_leader = 8, longest = 200, leader_step = 1.5;  // mm, of leaders

/// A direction of leaders, and how much it is disliked. mm
struct LeaderDirection {
  int degrees;
  double cost;
};

constexpr std::array<LeaderDirection, 16> oblique{{{60, 0},
                                                   {120, 0},
                                                   {45, 1},
                                                   {135, 1},
                                                   {300, 2},
                                                   {240, 2},
                                                   {315, 3},
                                                   {225, 3},
                                                   {30, 4},
                                                   {150, 4},
                                                   {75, 5},
                                                   {105, 5},
                                                   {330, 6},
                                                   {210, 6},
                                                   {285, 7},
                                                   {255, 7}}};

/// A possible place: its box, the way of its leader from the target, and how much it is disliked. mm
struct Spot {
  Rectangle box;
  std::vector<Vec2> leader;
  double cost = 0;
  CalloutTarget target{};
};

Rectangle box_from(const Vec2& corner, const Vec2& size) { return {corner, corner + size}; }

bool is_upright(const Vec2& direction) { return std::abs(direction.x) < 0.02; }
bool is_level(const Vec2& direction) { return std::abs(direction.y) < 0.02; }

// With a bend of the leader at a point; the callout is on one side of it.
Spot spot_at(const Callout& callout, const Vec2& bend, bool to_right, double landing) {
  const double way = to_right ? 1 : -1, width = callout.size.x;
  const Vec2 target = callout.target->point;
  if (callout.form == LeaderForm::reference)
    return {box_from(to_right ? bend : bend - Vec2(width, 0), callout.size),
            {target, bend, bend + Vec2(way * width, 0)}};
  const Vec2 end = bend + Vec2(way * landing, 0);
  return {box_from(end - Vec2(to_right ? 0 : width, callout.attach), callout.size), {target, bend, end}};
}

// With a leader of this length and direction.
std::vector<Spot> spots_along(const Callout& callout, const Vec2& along, double length, double landing) {
  const Vec2 end = callout.target->point + length * along;
  if (callout.form == LeaderForm::datum && is_upright(along)) {
    const Vec2 corner = end - Vec2(callout.size.x / 2, along.y > 0 ? 0 : callout.size.y);
    return {{box_from(corner, callout.size), {callout.target->point, end}}};
  }
  if (is_upright(along)) return {spot_at(callout, end, true, landing), spot_at(callout, end, false, landing)};
  const bool is_straight = is_level(along) && callout.form != LeaderForm::reference;
  return {spot_at(callout, end, along.x > 0, is_straight ? 0 : landing)};
}

// Where a perpendicular leader would cross lettering, that of a datum bends at the tip of its triangle.
void add_bent_datums(std::vector<Spot>& spots, const Callout& callout, double length, double text_height) {
  constexpr double for_bend = 20, min_rise = 0.2;  // mm; along the normal
  const Vec2 target = callout.target->point, normal = *callout.target->normal;
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0 && callout.target->is_border) continue;
    const Vec2 tip = target + sign * triangle * text_height * normal;
    for (int degrees = 15; degrees < 360; degrees += 15) {
      const Vec2 along = turned_to(degrees * std::numbers::pi / 180);
      if (degrees % 90 == 0 || sign * glm::dot(along, normal) < min_rise) continue;
      Spot spot = spot_at(callout, tip + length * along, along.x > 0, text_height);
      spot.leader.insert(spot.leader.begin() + 1, tip);
      spot.cost = length + for_bend;
      spots.push_back(std::move(spot));
    }
  }
}

// In line with a dimension line, then across it: where there is no other place.
void add_bent_in_line(std::vector<Spot>& spots, const Callout& callout, double length, double landing) {
  constexpr double for_bend = 1e4;  // mm
  const Vec2 elbow = callout.target->point + shortest_leader * *callout.target->normal;
  for (const double side : {1.0, -1.0}) {
    const Vec2 along = side * left_of(*callout.target->normal);
    for (const bool to_right : {true, false}) {
      if (!is_upright(along) && to_right != (along.x > 0)) continue;
      Spot spot = spot_at(callout, elbow + length * along, to_right, is_level(along) ? 0 : landing);
      spot.leader.insert(spot.leader.begin() + 1, elbow);
      spot.cost = length + for_bend;
      check(spot.leader.front() == callout.target->point, "a leader begins at its target");
      spots.push_back(std::move(spot));
    }
  }
}

// The possible places with leaders of this length.
std::vector<Spot> spots_of(const Callout& callout, double length, double landing) {
  constexpr double for_inside = 25, for_oblique = 12, for_slant_of_frame = 40;  // mm
  const std::optional<Vec2>& normal = callout.target->normal;
  std::vector<Spot> spots;
  const auto add = [&](const Vec2& along, double cost) {
    for (Spot& spot : spots_along(callout, along, length, landing)) {
      check(spot.leader.size() >= 2 && spot.leader.front() == callout.target->point, "a leader begins at its target");
      spot.cost = length + cost;
      spots.push_back(std::move(spot));
    }
  };
  const bool is_text = callout.form == LeaderForm::reference;
  if (normal && !is_text) {
    add(*normal, 0);
    if (!callout.target->is_border) add(-*normal, 0);
  }
  if (callout.target->in_line && callout.form != LeaderForm::datum) {
    if (normal) add_bent_in_line(spots, callout, length, landing);
    return spots;
  }
  if (callout.form == LeaderForm::datum) {
    if (normal) add_bent_datums(spots, callout, length, landing);
    return spots;
  }
  for (const LeaderDirection& direction : oblique) {
    const Vec2 along = turned_to(direction.degrees * std::numbers::pi / 180);
    const double weight = is_text ? for_oblique : for_slant_of_frame;
    const double slant = normal ? weight * (1 - std::abs(glm::dot(along, *normal))) : 0;
    const bool is_inside = normal && callout.target->is_border && glm::dot(along, *normal) < 0.05;
    add(along, direction.cost + slant + (is_inside ? for_inside : 0) + (normal && !is_text ? for_oblique : 0));
  }
  return spots;
}

bool has_inside(const TurnedBox& box) { return box.half.x > 0 && box.half.y > 0; }

/// Chooses places, one callout after another.
class CalloutPlacer {
 public:
  CalloutPlacer(const drawing::ViewDrawing& view, const Neighbours& neighbours)
      : view_(view), ink_(view), paper_(neighbours.paper), hatched_(hatched_boxes(view)) {
    for (const TurnedBox& box : neighbours.boxes) add(box);
  }

  [[nodiscard]] std::optional<Spot> best(const Callout& callout, double landing) const {
    std::optional<Spot> best;
    double least = HUGE_VAL;
    find_best(callout, landing, best, least);
    Callout other = callout;
    for (const CalloutTarget& target : callout.others) {
      other.target = target;
      find_best(other, landing, best, least);
    }
    return best;
  }

  // Replaces the best place by one that costs less, if there is one.
  void find_best(const Callout& callout, double landing, std::optional<Spot>& best, double& least) const {
    for (double length = shortest_leader; length <= longest && length < least; length += leader_step)
      for (Spot& spot : spots_of(callout, length, landing)) {
        if (spot.cost >= least || !is_free(spot.box)) continue;
        const double cost = spot.cost + cost_of(spot);
        if (cost >= least) continue;
        least = cost;
        best = std::move(spot);
        best->target = *callout.target;
      }
  }

  // At a given position, from the side whose leader does not cross the callout, or the nearer one.
  [[nodiscard]] Spot fixed(const Callout& callout, double landing) const {
    const Rectangle box = box_at(callout, *callout.at);
    const bool is_text = callout.form == LeaderForm::reference;
    const double y = box.min.y + (is_text ? 0 : callout.attach), away = is_text ? 0 : landing;
    const Spot right = spot_at(callout, {box.min.x - away, y}, true, landing);
    const Spot left = spot_at(callout, {box.max.x + away, y}, false, landing);
    const auto rank = [&](const Spot& spot) {
      const bool crosses = overlap(line_box(spot.leader[0], spot.leader[1]), turned_box(box));
      return std::pair(crosses, glm::length(spot.leader[0] - spot.leader[1]));
    };
    Spot best = rank(left) < rank(right) ? left : right;
    best.target = *callout.target;
    return best;
  }

  [[nodiscard]] bool is_free(const Rectangle& box) const {
    const Rectangle wide = box.grown(callout_clearance);
    if (paper_ && !paper_->holds(wide)) return false;
    const TurnedBox turned = turned_box(wide);
    return areas_.overlaps(turned, 0) == 0 && line_index_.overlaps(turned, 0) == 0 &&
           std::none_of(hatched_.begin(), hatched_.end(), [&](const Rectangle& one) { return one.overlaps(wide); }) &&
           ink_.in(turned) == 0;
  }

  void add(const Spot& spot) {
    add(turned_box(spot.box));
    for (std::size_t i = 1; i < spot.leader.size(); ++i) add(line_box(spot.leader[i - 1], spot.leader[i]));
  }

 private:
  void add(const TurnedBox& box) {
    if (has_inside(box)) return areas_.add({&box, 1});
    lines_.push_back(box);
    line_index_.add({&box, 1});
  }

  // Of what the leader crosses; infinite for lettering.
  [[nodiscard]] double cost_of(const Spot& spot) const {
    constexpr double in_view = 60, for_line = 20, for_ink = 2;  // mm
    constexpr double at_target = 0.5;                           // mm of the leader that touch what it means
    constexpr double leader_clearance = 0.8;                    // mm to lettering and parallel lines
    const Rectangle whole{view_.box.min, view_.box.max};
    double cost = spot.box.overlaps(whole) ? in_view : 0;
    for (std::size_t i = 1; i < spot.leader.size(); ++i) {
      const Vec2 &from = spot.leader[i - 1], &to = spot.leader[i];
      if (from == to) continue;
      const Vec2 start = i == 1 ? from + at_target * glm::normalize(to - from) : from;
      const TurnedBox line = line_box(start, to);
      const auto is_met = [&line](const TurnedBox& other) { return overlap(line, other); };
      TurnedBox wide = line;
      wide.half.y = leader_clearance;
      const auto is_near = [&wide](const TurnedBox& other) { return overlap(wide, other); };
      if (areas_.overlaps(wide, 0) > 0) return HUGE_VAL;
      const auto is_along = [&](const TurnedBox& other) {
        return is_met(other) || (is_near(other) && look_parallel(line, other));
      };
      cost += for_line * static_cast<double>(std::count_if(lines_.begin(), lines_.end(), is_along)) +
              for_ink * ink_.in(line);
    }
    check(cost >= 0, "no place is better than a free one");
    return cost;
  }

  const drawing::ViewDrawing& view_;
  InkIndex ink_;
  std::optional<Rectangle> paper_;
  std::vector<Rectangle> hatched_;
  BoxIndex areas_{}, line_index_{};
  std::vector<TurnedBox> lines_{};  ///< again, to see what is parallel
};

// A triangle on a line, on the side of its leader. ISO 5459.
Fill datum_triangle(const CalloutTarget& target, const Vec2& leader, const DimensionStyle& style) {
  const Vec2 normal = target.normal.value_or(leader);
  const Vec2 along = glm::dot(normal, leader) < 0 ? -normal : normal;
  const Vec2 across = style.text / 2 * left_of(along);
  return {{{target.point + across, target.point - across, target.point + triangle * style.text * along}}};
}

// Before the callout is drawn. A callout without lines of its own is a text; its leader has it.
LeaderObject leader_object(const Layer& notes, const Callout& callout, const Spot& spot, const DimensionStyle& style) {
  LeaderObject object{notes.strokes.back().points, spot.target.end, style.arrow()};
  const std::size_t texts = notes.texts.size();
  const bool is_text = callout.form == LeaderForm::reference && callout.strokes.empty() && callout.fills.empty();
  object.texts = {texts, texts + (is_text ? callout.texts.size() : 0)};
  if (!is_text) return object;
  for (const Text& text : callout.texts) object.lines.push_back(text.text);
  object.text_corner = {spot.box.min.x, spot.box.max.y};
  object.text_height = style.text;
  return object;
}

void draw_callout(CalloutLayers& layers, const Callout& callout, const Spot& spot, const DimensionStyle& style) {
  const CalloutTarget& target = spot.target;
  const std::size_t fills = layers.notes.fills.size();
  const Vec2 along = glm::normalize(spot.leader[1] - target.point);
  Stroke& leader = layers.notes.strokes.emplace_back();
  for (const Vec2& p : spot.leader)
    if (leader.points.empty() || leader.points.back() != p) leader.points.push_back(p);
  check(!leader.points.empty(), "a leader begins at its target");
  constexpr double around = 0.5;  // heights of capitals. ISO 1101
  if (callout.all_around) layers.symbols.strokes.push_back(circle_at(spot.leader[1], around * style.text));
  if (callout.form == LeaderForm::datum)
    layers.notes.fills.push_back(datum_triangle(target, along, style));
  else if (target.end == LeaderEnd::arrow)
    layers.notes.fills.push_back(arrow_at(target.point, -along, style));
  else if (target.end == LeaderEnd::dot)
    layers.notes.fills.push_back(dot_at(target.point));
  if (callout.form != LeaderForm::datum) {
    LeaderObject object = leader_object(layers.notes, callout, spot, style);
    object.strokes = {layers.notes.strokes.size() - 1, layers.notes.strokes.size()};
    object.fills = {fills, layers.notes.fills.size()};
    layers.notes.leaders.push_back(std::move(object));
  }
  draw_at(layers, callout, {spot.box.min.x, spot.box.max.y});
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

double callout_room(double height) { return shortest_leader + height + callout_clearance; }

CalloutFaults place_callouts(CalloutLayers& layers, std::span<const Callout> callouts, const drawing::ViewDrawing& view,
                             const DimensionStyle& style, const Neighbours& neighbours) {
  const double landing = style.text;
  CalloutPlacer placer(view, neighbours);
  CalloutFaults faults;
  const auto number_of = [&](const Callout& callout) { return static_cast<std::size_t>(&callout - callouts.data()); };
  for (const Callout& callout : callouts) {
    if (!callout.at) continue;
    const Spot spot = placer.fixed(callout, landing);
    if (!placer.is_free(spot.box)) faults.crossings.push_back(callout.name);
    placer.add(spot);
    draw_callout(layers, callout, spot, style);
    faults.places.emplace_back(number_of(callout), turned_box(spot.box));
  }
  // Those with the least choice first. Places are only taken: where there is none for one, there is none for a wider
  // one.
  for (const LeaderForm form : {LeaderForm::datum, LeaderForm::landing, LeaderForm::reference}) {
    std::map<std::array<double, 4>, double> hopeless;  // least width
    for (const Callout& callout : callouts) {
      if (callout.at || callout.form != form) continue;
      const Vec2& to = callout.target->point;
      const std::array<double, 4> like{to.x, to.y, callout.size.y, callout.attach};
      const auto failed = hopeless.find(like);
      const bool may_have_place =
          !callout.others.empty() || failed == hopeless.end() || callout.size.x < failed->second;
      if (const auto spot = may_have_place ? placer.best(callout, landing) : std::nullopt) {
        placer.add(*spot);
        draw_callout(layers, callout, *spot, style);
        faults.places.emplace_back(number_of(callout), turned_box(spot->box));
      } else {
        if (may_have_place && callout.others.empty()) hopeless[like] = callout.size.x;
        faults.without_place.push_back(number_of(callout));
      }
    }
  }
  check(faults.places.size() + faults.without_place.size() == callouts.size(), "every callout is placed or reported");
  return faults;
}

}  // namespace epura::sheet
