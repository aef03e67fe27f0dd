// SPDX-License-Identifier: Apache-2.0
#include "annotations/label_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

constexpr double clear = 0.5;  // mm between a label and lines
const Vec2 apart(2.5, 0.4);    // mm between a label and other labels, besides: they are not one text
constexpr double near = 4.5;   // mm to a label that needs no leader
constexpr std::array<double, 17> steps{0.8, 2, 3.5, 5, 7, 9, 12, 16, 20, 25, 30, 36, 43, 50, 60, 72, 86};  // mm
constexpr std::array<Vec2, 16> sides{Vec2(1, 1),   Vec2(-1, 1),   Vec2(1, -1),   Vec2(-1, -1),
                                     Vec2(0, 1),   Vec2(1, 0),    Vec2(0, -1),   Vec2(-1, 0),
                                     Vec2(0.5, 1), Vec2(-0.5, 1), Vec2(0.5, -1), Vec2(-0.5, -1),
                                     Vec2(1, 0.5), Vec2(-1, 0.5), Vec2(1, -0.5), Vec2(-1, -0.5)};

// What else a place costs, in mm of distance.
constexpr double later_anchor = 0.3, later_side = 0.05;
constexpr double not_outwards = 1.5, not_inside = 4;
constexpr double leader = 3;
constexpr double on_line = 60;                          // for each line under the label
constexpr double crossing = 25, crossed_by_leader = 4;  // for each line between the label and its anchor
constexpr int max_counted = 3;                          // the parts of a curve are many lines
constexpr int max_rounds = 4, max_attempts = 5;

// From past the corners of the mark to the nearest point of the label.
std::array<Vec2, 2> tie_between(const Vec2& anchor, const Rectangle& box, double from) {
  const Vec2 end = glm::clamp(anchor, box.min, box.max);
  const double length = glm::length(end - anchor), start = from * std::numbers::sqrt2;
  if (length <= start) return {anchor, anchor};
  return {anchor + (end - anchor) * (start / length), end};
}

bool needs_leader(const Vec2& anchor, const Rectangle& box) {
  return glm::length(glm::clamp(anchor, box.min, box.max) - anchor) > near;
}

TurnedBox box_with_room(const Rectangle& box) { return turned_box({box.min - apart, box.max + apart}); }

}  // namespace

struct LabelRoom::Candidate {
  Vec2 anchor;
  Rectangle box;
  double base;
};

namespace {

// Moved into the area; nothing if it covers the anchor or its mark there.
std::optional<Rectangle> beside(const LabelAnchor& anchor, const Vec2& side, double step, const Label& label,
                                const Rectangle& area) {
  const Vec2 half = label.size / 2.0;
  const double away = label.from + step;
  const Vec2 centre = anchor.at + side * (half + away * (side.x != 0 && side.y != 0 ? std::numbers::sqrt2 / 2 : 1.0));
  const Vec2 first = area.min + half, last = area.max - half;
  if (first.x > last.x || first.y > last.y) return std::nullopt;
  const Vec2 inside = glm::clamp(centre, first, last);
  const Rectangle box{inside - half, inside + half};
  const Rectangle mark = Rectangle{anchor.at, anchor.at}.grown(label.from);
  if (inside != centre && (box.grown(clear).overlaps(mark) || box.grown(clear).holds(mark))) return std::nullopt;
  return box;
}

}  // namespace

// Letters may reach a little beyond their boxes.
LabelRoom::LabelRoom(const Rectangle& area) : area_(area.grown(-clear)) {}

void LabelRoom::add_line(const Vec2& from, const Vec2& to) { lines_.add(std::array{line_box(from, to)}); }

void LabelRoom::add_mark(const TurnedBox& box) {
  lines_.add(std::array{box});
  solids_.add(std::array{box});
}

void LabelRoom::add_lettering(const TurnedBox& box) {
  solids_.add(std::array{box});
  lettering_.add(std::array{box});
}

void LabelRoom::take(const LabelPlace& place) {
  solids_.add(std::array{box_with_room(place.box)});
  lettering_.add(std::array{turned_box(place.box.grown(clear))});
  if (place.tie[0] != place.tie[1]) add_mark(line_box(place.tie[0], place.tie[1]));
}

void LabelRoom::give_back(const LabelPlace& place) {
  solids_.remove(std::array{box_with_room(place.box)});
  lettering_.remove(std::array{turned_box(place.box.grown(clear))});
  if (place.tie[0] == place.tie[1]) return;
  const std::array tie{line_box(place.tie[0], place.tie[1])};
  lines_.remove(tie);
  solids_.remove(tie);
}

// Infinite where the label must not stand; once it is not below the bound, it is not complete.
double LabelRoom::cost_of(const Label& label, const Candidate& candidate, double bound) const {
  if (!area_.holds(candidate.box)) return HUGE_VAL;
  const TurnedBox wide = turned_box(candidate.box.grown(clear));
  if (solids_.overlaps(wide) > 0) return HUGE_VAL;
  double cost = candidate.base + on_line * std::min(lines_.overlaps(wide), max_counted);
  if (cost >= bound) return cost;
  const auto [start, end] = tie_between(candidate.anchor, candidate.box, label.from);
  if (start == end) return cost;
  const TurnedBox tie = line_box(start, end);
  if (lettering_.overlaps(tie) > 0) return HUGE_VAL;
  const bool has_leader = needs_leader(candidate.anchor, candidate.box);
  return cost + (has_leader ? crossed_by_leader : crossing) * std::min(lines_.overlaps(tie), max_counted);
}

// The cheapest first, by what they cost apart from what is there.
std::vector<LabelRoom::Candidate> LabelRoom::candidates_for(const Label& label) const {
  std::vector<Candidate> candidates;
  double first = 0;
  for (const LabelAnchor& anchor : label.anchors) {
    const auto add = [&](const Vec2& side, double step, double more) {
      const auto box = beside(anchor, side, step, label, area_);
      if (!box) return;
      check(area_.holds(*box, 1e-9 * (area_.size().x + area_.size().y)), "a label is in its area");
      more += (label.inside ? not_inside : 0) + (needs_leader(anchor.at, *box) ? leader : 0);
      candidates.push_back({anchor.at, *box, first + step + more});
    };
    if (label.inside)
      candidates.push_back({anchor.at, {anchor.at - label.size / 2.0, anchor.at + label.size / 2.0}, first});
    const bool has_direction = anchor.outwards != Vec2(0, 0);
    for (const double step : steps) {
      if (has_direction) add(anchor.outwards, step, 0);
      for (std::size_t s = 0; s < sides.size(); ++s)
        add(sides[s], step, (has_direction ? not_outwards : 0) + later_side * static_cast<double>(s));
    }
    first += later_anchor;
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.base < b.base; });
  return candidates;
}

std::optional<LabelPlace> LabelRoom::best_place(const Label& label) const {
  const std::vector<Candidate> candidates = candidates_for(label);
  const Candidate* best = nullptr;
  double least = HUGE_VAL;
  for (const Candidate& candidate : candidates) {
    if (candidate.base >= least) break;
    const double cost = cost_of(label, candidate, least);
    if (cost >= least) continue;
    least = cost;
    best = &candidate;
  }
  if (best == nullptr) return std::nullopt;
  const Rectangle around_anchor{best->anchor - clear, best->anchor + clear};
  return LabelPlace{best->box, best->anchor, tie_between(best->anchor, best->box, label.from),
                    needs_leader(best->anchor, best->box), lines_.overlaps(turned_box(around_anchor)) > 0};
}

LabelRoom::Places LabelRoom::placed_in_order(std::span<const Label> labels, std::span<const std::size_t> order) {
  Places places(labels.size());
  for (int round = 0; round < max_rounds; ++round) {
    bool moved = false;
    for (const std::size_t i : order) {
      if (places[i]) give_back(*places[i]);
      std::optional<LabelPlace> now = best_place(labels[i]);
      if (!now) now = places[i];
      moved = moved || (now && (!places[i] || now->box.min != places[i]->box.min));
      places[i] = now;
      if (now) take(*now);
    }
    if (!moved) break;
  }
  return places;
}

std::vector<std::optional<LabelPlace>> LabelRoom::place(std::span<const Label> labels) {
  // No label covers the only point that another can name.
  constexpr double point = 0.01;  // mm
  for (const Label& label : labels)
    if (label.anchors.size() == 1 && label.from == 0 && !label.inside)
      solids_.add(std::array{turned_box(Rectangle{label.anchors[0].at, label.anchors[0].at}.grown(point))});
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Places best;
  auto least = labels.size() + 1;
  for (int attempt = 0; attempt < max_attempts && least > 0; ++attempt) {
    Places places = placed_in_order(labels, order);
    for (const std::optional<LabelPlace>& place : places)
      if (place) give_back(*place);
    const auto is_missing = [&places](std::size_t i) { return !places[i]; };
    const auto missing = static_cast<std::size_t>(std::count_if(order.begin(), order.end(), is_missing));
    std::stable_partition(order.begin(), order.end(), is_missing);
    if (missing >= least) continue;
    least = missing;
    best = std::move(places);
  }
  check(best.size() == labels.size(), "every label has a place or none");
  for (const std::optional<LabelPlace>& place : best)
    if (place) take(*place);
  return best;
}

}  // namespace epura::sheet
