// SPDX-License-Identifier: Apache-2.0
#include "sheet/callouts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>

#include "sheet/fit_text.hpp"

namespace epura::sheet {

namespace {

constexpr double side = 0.25, below = 0.5;  // free around texts on a reference line, in heights of capitals
constexpr double clearance = 1.5;           // mm, between a callout and everything else
constexpr double shortest = 8, longest = 200, step = 1.5;  // mm, of leaders

/// A direction of leaders, and how much it is disliked. mm
struct Direction {
  int degrees;
  double cost;
};

constexpr std::array<Direction, 16> oblique{{{60, 0},
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

/// A possible place: its box, and where the leader bends into the reference line.
struct Spot {
  Rectangle box;
  Vec2 bend, end;  ///< of the reference line
};

Spot spot_at(const Callout& callout, const Vec2& bend, bool to_right) {
  const Vec2 corner = to_right ? bend : bend - Vec2(callout.size.x, 0);
  return {{corner, corner + callout.size}, bend, bend + Vec2(to_right ? callout.size.x : -callout.size.x, 0)};
}

bool has_area(const TurnedBox& box) { return box.half.x > 0 && box.half.y > 0; }

/// Chooses places, one callout after another.
class Placer {
 public:
  Placer(const drawing::ViewDrawing& view, const Neighbours& neighbours) : view_(view), paper_(neighbours.paper) {
    for (const TurnedBox& box : neighbours.boxes) add(box);
    for (const drawing::CutFace& face : view.cut_faces)
      for (const std::vector<Vec2>& ring : face.rings) {
        Rectangle box{ring.front(), ring.front()};
        for (const Vec2& p : ring) box = united(box, {p, p});
        hatched_.push_back(box);
      }
  }

  [[nodiscard]] std::optional<Spot> best(const Callout& callout) const {
    const Vec2 target = callout.target->point;
    std::optional<Spot> best;
    double least = HUGE_VAL;
    for (double length = shortest; length <= longest && length < least; length += step)
      for (const Direction& direction : oblique) {
        const double known = length + direction.cost;
        if (known >= least) continue;
        const Vec2 along = turned_to(direction.degrees * std::numbers::pi / 180);
        const Spot spot = spot_at(callout, target + length * along, along.x > 0);
        if (!is_free(spot.box)) continue;
        const double cost = known + cost_of(spot, target);
        if (cost >= least) continue;
        least = cost;
        best = spot;
      }
    return best;
  }

  // At a given position, from the end of the reference line whose leader does not cross the text, or the nearer one.
  [[nodiscard]] Spot fixed(const Callout& callout) const {
    const Rectangle box = box_at(callout, *callout.at);
    const Vec2 target = callout.target->point;
    const Spot right = spot_at(callout, box.min, true), left = spot_at(callout, {box.max.x, box.min.y}, false);
    const auto rank = [&](const Spot& spot) {
      const bool crosses = overlap(line_box(target, spot.bend), turned_box(box));
      return std::pair(crosses, glm::length(target - spot.bend));
    };
    return rank(left) < rank(right) ? left : right;
  }

  [[nodiscard]] bool is_free(const Rectangle& box) const {
    const Rectangle wide = box.grown(clearance);
    if (paper_ && !paper_->holds(wide)) return false;
    const TurnedBox turned = turned_box(wide);
    const auto is_met = [&turned](const TurnedBox& other) { return overlap(turned, other); };
    return std::none_of(areas_.begin(), areas_.end(), is_met) && std::none_of(lines_.begin(), lines_.end(), is_met) &&
           std::none_of(hatched_.begin(), hatched_.end(), [&](const Rectangle& one) { return one.overlaps(wide); }) &&
           ink_in(turned, view_) == 0;
  }

  void add(const Spot& spot, const Vec2& target) {
    add(turned_box(spot.box));
    add(line_box(target, spot.bend));
    add(line_box(spot.bend, spot.end));
  }

 private:
  void add(const TurnedBox& box) { (has_area(box) ? areas_ : lines_).push_back(box); }

  // Infinite if the leader crosses lettering.
  [[nodiscard]] double cost_of(const Spot& spot, const Vec2& target) const {
    constexpr double in_view = 60, for_line = 20, for_ink = 2;  // mm
    constexpr double at_target = 0.5;                           // mm of the leader that touch what it means
    const Vec2 along = glm::normalize(spot.bend - target);
    const TurnedBox leader = line_box(target + at_target * along, spot.bend);
    const auto is_met = [&leader](const TurnedBox& other) { return overlap(leader, other); };
    if (std::any_of(areas_.begin(), areas_.end(), is_met)) return HUGE_VAL;
    const Rectangle whole{view_.min, view_.max};
    return (spot.box.overlaps(whole) ? in_view : 0) +
           for_line * static_cast<double>(std::count_if(lines_.begin(), lines_.end(), is_met)) +
           for_ink * ink_in(leader, view_);
  }

  const drawing::ViewDrawing& view_;
  std::optional<Rectangle> paper_;
  std::vector<TurnedBox> areas_, lines_;
  std::vector<Rectangle> hatched_;
};

void draw(Layer& layer, const Callout& callout, const Spot& spot, const DimensionStyle& style) {
  const Vec2 target = callout.target->point;
  layer.strokes.emplace_back().points = {target, spot.bend, spot.end};
  if (callout.target->end == scene::LeaderEnd::arrow)
    layer.fills.push_back(arrow_at(target, glm::normalize(target - spot.bend), style));
  if (callout.target->end == scene::LeaderEnd::dot) layer.fills.push_back(dot_at(target));
  draw_at(layer, callout, {spot.box.min.x, spot.box.max.y});
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
  callout.underlined = has_leader;
  const double left = has_leader ? side * style.text : 0;
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
  const double indent = style.lettering.width(std::to_string(notes.size()) + ". ", style.text) + side * style.text;
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

void draw_at(Layer& layer, const Callout& callout, const Vec2& upper_left) {
  const Vec2 corner = box_at(callout, upper_left).min;
  for (Text text : callout.texts) {
    text.at += corner;
    layer.texts.push_back(std::move(text));
  }
}

double callout_room(double height) { return shortest + height + clearance; }

CalloutFaults place_callouts(Layer& layer, std::span<const Callout> callouts, const drawing::ViewDrawing& view,
                             const DimensionStyle& style, const Neighbours& neighbours) {
  Placer placer(view, neighbours);
  CalloutFaults faults;
  for (const Callout& callout : callouts) {
    if (!callout.at) continue;
    const Spot spot = placer.fixed(callout);
    if (!placer.is_free(spot.box)) faults.crossings.push_back(callout.name);
    placer.add(spot, callout.target->point);
    draw(layer, callout, spot, style);
  }
  for (const Callout& callout : callouts) {
    if (callout.at) continue;
    if (const auto spot = placer.best(callout)) {
      placer.add(*spot, callout.target->point);
      draw(layer, callout, *spot, style);
    } else {
      faults.without_place.push_back(callout.name);
    }
  }
  return faults;
}

}  // namespace epura::sheet
