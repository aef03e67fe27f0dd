// SPDX-License-Identifier: Apache-2.0
#include "annotations/balloons.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "annotations/blank_paper.hpp"
#include "annotations/callouts.hpp"
#include "base/error.hpp"
#include "dimensions/costs.hpp"

namespace epura::sheet {

namespace {

constexpr double first_ring = 7, next_ring = 6;  // mm between the view and the circles, and between rings
constexpr double balloon_size = 1.1;             // radius in heights of its number
constexpr int rings = 9;
constexpr double ring_step = 2;          // mm between possible places on a ring
constexpr double balloons_apart = 1.25;  // mm; BalloonSizes::apart around views

/// Sizes of the balloons of one call, mm.
struct BalloonSizes {
  double text, radius;
  double apart;  ///< free around a circle
};

/// A possible place of a balloon.
struct BalloonPlace {
  Vec2 centre;
  int ring;
  bool is_between = false;  ///< the parts of the view
};

// Around the view, ring by ring, counterclockwise.
std::vector<BalloonPlace> places_around(const Rectangle& view, double radius) {
  std::vector<BalloonPlace> places;
  for (int ring = 0; ring < rings; ++ring) {
    const Rectangle r = view.grown(radius + first_ring + next_ring * ring);
    const Vec2 size = r.size();
    const int across = std::max(static_cast<int>(size.x / ring_step), 1),
              up = std::max(static_cast<int>(size.y / ring_step), 1);
    for (int i = 0; i <= across; ++i) {
      const double x = r.min.x + size.x * i / across;
      places.push_back({{x, r.max.y}, ring});
      places.push_back({{x, r.min.y}, ring});
    }
    for (int i = 1; i < up; ++i) {
      const double y = r.min.y + size.y * i / up;
      places.push_back({{r.max.x, y}, ring});
      places.push_back({{r.min.x, y}, ring});
    }
  }
  check(places.size() >= std::size_t{4} * rings, "balloons have places on all sides of a view");
  return places;
}

// On blank paper of the view itself, between its parts, where the border of the view is farther away.
void add_places_between(std::vector<BalloonPlace>& places, const Vec2& target, const drawing::ViewDrawing& view,
                        const BlankPaper& blank, const BalloonSizes& sizes) {
  const double reach = inside_by(target, view) + first_ring + sizes.radius;
  const Vec2 first = glm::floor((target - reach - view.box.min) / ring_step),
             last = glm::ceil((target + reach - view.box.min) / ring_step);
  for (double x = first.x; x <= last.x; ++x)
    for (double y = first.y; y <= last.y; ++y) {
      const Vec2 centre = view.box.min + ring_step * Vec2(x, y);
      const Rectangle box = Rectangle{centre, centre}.grown(sizes.radius + sizes.apart);
      if (glm::distance(centre, target) < reach && Rectangle{view.box.min, view.box.max}.overlaps(box) &&
          blank.holds(box))
        places.push_back({centre, 0, true});
    }
}

// Beside a box, ring by ring, in its directions; at each end, one is in the middle.
std::vector<BalloonPlace> places_beside(const TurnedBox& box, const BalloonSizes& sizes) {
  std::vector<BalloonPlace> places;
  const Vec2 across = left_of(box.along);
  for (int ring = 0; ring < rings; ++ring) {
    const Vec2 half = box.half + sizes.radius + sizes.apart + next_ring * ring;
    const auto add = [&](double x, double y) { places.push_back({box.centre + x * box.along + y * across, ring}); };
    const Vec2 steps = glm::ceil(2.0 * half / ring_step);
    for (int i = 0; i <= static_cast<int>(steps.x); ++i)
      for (const double y : {half.y, -half.y}) add(half.x * (2 * i / steps.x - 1), y);
    const int up = static_cast<int>(std::ceil(half.y / ring_step));
    for (int i = 1 - up; i < up; ++i)
      for (const double x : {half.x, -half.x}) add(x, half.y * i / up);
  }
  return places;
}

Vec2 nearest_point(const TurnedBox& box, const Vec2& p) {
  const Vec2 across = left_of(box.along), from = p - box.centre;
  const Vec2 inside = glm::clamp(Vec2(glm::dot(from, box.along), glm::dot(from, across)), -box.half, box.half);
  return box.centre + inside.x * box.along + inside.y * across;
}

Vec2 leader_end(const BalloonTarget& target, const Vec2& centre) {
  return target.beside ? nearest_point(*target.beside, centre) : target.point;
}

// What it takes up on paper.
PlacedDimension drawn(const BalloonTarget& target, const BalloonPlace& place, const BalloonSizes& sizes) {
  constexpr double at_target = 0.5;  // mm of the leader that touch what it means
  PlacedDimension placed;
  placed.zones = {turned_box(Rectangle{place.centre, place.centre}.grown(sizes.radius + sizes.apart))};
  placed.text_boxes = placed.zones;
  const Vec2 leader = leader_end(target, place.centre) - place.centre;
  const double length = glm::length(leader);
  if ((target.beside && place.ring == 0) || length <= sizes.radius + at_target) return placed;
  const auto at = [&](double distance) { return place.centre + distance / length * leader; };
  placed.leaders = {{at(length - at_target), at(sizes.radius), at_target}};
  placed.lines = {line_box(placed.leaders.front().tip, placed.leaders.front().elbow)};
  return placed;
}

// Leaders are oblique (ISO 128-2), and go over no other parts. Beside a text, its end is best.
double cost_of(const BalloonTarget& target, const BalloonPlace& place, const BlankPaper& blank) {
  constexpr double for_ring = 6, for_upright = 8;
  const double rings_out = for_ring * place.ring;
  if (const auto& box = target.beside)
    return cost_of_way * glm::length(place.centre - (box->centre + box->half.x * box->along)) + rings_out;
  const Vec2 leader = place.centre - target.point;
  const double least = std::min(std::abs(leader.x), std::abs(leader.y));
  return cost_of_way * glm::length(leader) + rings_out + (least < 0.18 * glm::length(leader) ? for_upright : 0) +
         (place.is_between ? cost_in_view : 0) + cost_of_other * blank.entries(target.point, place.centre);
}

PlacementItem item_of(const BalloonTarget& target, const drawing::ViewDrawing& view, const BalloonSizes& sizes,
                      const BlankPaper& blank) {
  PlacementItem item;
  item.usual = [&](const PlacedDimension*) {
    std::vector<BalloonPlace> places = target.beside ? places_beside(*target.beside, sizes)
                                                     : places_around({view.box.min, view.box.max}, sizes.radius);
    if (!target.beside) add_places_between(places, target.point, view, blank, sizes);
    const std::vector<Rectangle> hatched = hatched_boxes(view);
    std::vector<ItemPlacement> placements;
    for (const BalloonPlace& place : places) {
      const Rectangle box = Rectangle{place.centre, place.centre}.grown(sizes.radius + sizes.apart);
      if (std::none_of(hatched.begin(), hatched.end(), [&](const Rectangle& one) { return one.overlaps(box); }))
        placements.push_back(
            {[=, &target, &sizes] { return drawn(target, place, sizes); }, cost_of(target, place, blank)});
    }
    return placements;
  };
  if (!target.beside)
    item.instead = [&](const PlacedDimension& other) {
      const bool is_between = around(other.zones.front()).overlaps({view.box.min, view.box.max});
      const BalloonPlace place{other.zones.front().centre, 0, is_between};
      return std::optional(ItemPlacement(drawn(target, place, sizes), cost_of(target, place, blank)));
    };
  item.order = {inside_by(target.point, view), 0, 0};
  item.rank = ItemRank::required;
  item.is_clear = true;
  check(sizes.radius > 0 && sizes.apart > 0, "balloons take up room");
  return item;
}

void draw(Layer& layer, const BalloonTarget& target, const PlacedDimension& placed, const BalloonSizes& sizes,
          const DimensionStyle& style) {
  const Vec2 centre = placed.zones.front().centre, end = leader_end(target, centre);
  layer.strokes.push_back(circle_at(centre, sizes.radius));
  layer.texts.push_back({target.number, centre - Vec2(0, sizes.text / 2), sizes.text, 0, Align::middle, "balloon"});
  if (placed.leaders.empty()) return;
  const Vec2 along = glm::normalize(end - centre);
  layer.strokes.emplace_back().points = {centre + sizes.radius * along, end};
  if (!target.beside) layer.fills.push_back(target.on_line ? arrow_at(end, along, style) : dot_at(end));
}

// Those beside texts are as small as lettering may be, and as near as dimension lines are to texts.
BalloonSizes sizes_of(std::span<const BalloonTarget> targets, const DimensionStyle& style) {
  if (targets.empty() || !targets.front().beside)
    return {balloon_text(style.text), balloon_radius(style.text), balloons_apart};
  BalloonSizes sizes{smallest_lettering, balloon_size * smallest_lettering, style.above()};
  for (const BalloonTarget& target : targets)
    sizes.radius = std::max(sizes.radius, style.lettering.width(target.number, sizes.text) / 2 + style.above());
  return sizes;
}

}  // namespace

double balloon_text(double dimension_text) { return dimension_text < 3 ? 3.5 : 5; }

double balloon_radius(double dimension_text) { return balloon_size * balloon_text(dimension_text); }

double balloon_room(double dimension_text) {
  return first_ring + 2 * (balloon_radius(dimension_text) + balloons_apart);
}

std::vector<std::string> place_balloons(Layer& layer, std::span<const BalloonTarget> targets,
                                        const drawing::ViewDrawing& view, const DimensionStyle& style,
                                        const Neighbours& neighbours) {
  const BalloonSizes sizes = sizes_of(targets, style);
  const BlankPaper blank(view);
  std::vector<PlacementItem> items;
  for (const BalloonTarget& target : targets) items.push_back(item_of(target, view, sizes, blank));
  const PlacedDimensions placed = place_items(items, {view, neighbours});
  std::vector<std::string> left_out;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (placed[i])
      draw(layer, targets[i], *placed[i], sizes, style);
    else
      left_out.push_back(targets[i].number);
  }
  return left_out;
}

}  // namespace epura::sheet
