// SPDX-License-Identifier: Apache-2.0
#include "annotations/balloons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "annotations/callouts.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

namespace epura::sheet {

namespace {

constexpr double first_ring = 7, next_ring = 6;  // mm between the view and the circles, and between rings
constexpr double balloon_size = 1.1;             // radius in heights of its number
constexpr int rings = 9;
constexpr double ring_step = 2;         // mm between possible places on a ring
constexpr double balloons_apart = 2.5;  // mm; BalloonSizes::apart around views

/// Sizes of the balloons of one call, mm.
struct BalloonSizes {
  double text, radius;
  double apart;  ///< between circles, and between them and other things
};

/// A possible place of a balloon.
struct BalloonPlace {
  Vec2 centre;
  int ring;
};

/// A balloon that has its place.
struct Placed {
  std::size_t target;
  BalloonPlace place;
};

bool do_leaders_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double s = cross(b - a, c - a), t = cross(b - a, d - a), u = cross(d - c, a - c), v = cross(d - c, b - c);
  return (s > 0) != (t > 0) && (u > 0) != (v > 0);
}

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

Vec2 leader_end(const BalloonTarget& target, const BalloonPlace& place) {
  return target.beside ? nearest_point(*target.beside, place.centre) : target.point;
}

/// Chooses places, one balloon after another.
class BalloonPlacer {
 public:
  BalloonPlacer(std::span<const BalloonTarget> targets, const drawing::ViewDrawing& view, const BalloonSizes& sizes,
                const Neighbours& neighbours)
      : targets_(targets), sizes_(sizes), neighbours_(neighbours), places_(targets.size()) {
    const std::vector<Rectangle> hatched = hatched_boxes(view);
    const auto is_free = [&](const BalloonPlace& place) {
      const Rectangle box = Rectangle{place.centre, place.centre}.grown(sizes.radius + sizes.apart);
      if (neighbours.paper && !neighbours.paper->holds(box)) return false;
      const TurnedBox turned = turned_box(box);
      return std::none_of(neighbours.boxes.begin(), neighbours.boxes.end(),
                          [&turned](const TurnedBox& other) { return overlap(turned, other); }) &&
             std::none_of(hatched.begin(), hatched.end(),
                          [&box](const Rectangle& face) { return face.overlaps(box); }) &&
             ink_in(turned, view) == 0;
    };
    const auto free_of = [&](std::vector<BalloonPlace> places) {
      std::erase_if(places, [&](const BalloonPlace& place) { return !is_free(place); });
      return places;
    };
    std::vector<BalloonPlace> around_view;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (targets[i].beside)
        places_[i] = free_of(places_beside(*targets[i].beside, sizes));
      else if (around_view.empty())
        places_[i] = around_view = free_of(places_around({view.box.min, view.box.max}, sizes.radius));
      else
        places_[i] = around_view;
    }
    check(sizes.radius > 0 && sizes.apart > 0, "balloons take up room");
  }

  // Adds a balloon where it costs least beside those that are placed; returns false if there is no place.
  bool add(std::size_t target) {
    std::optional<Placed> best;
    double least = HUGE_VAL;
    for (const BalloonPlace& place : places_[target]) {
      const Placed one{target, place};
      const double cost = cost_of(one);
      if (cost >= least || !suits(one)) continue;
      const double whole = cost + penalty_of_crossings(one);
      if (whole >= least) continue;
      least = whole;
      best = one;
    }
    if (best) placed_.push_back(*best);
    return best.has_value();
  }

  // Adds all balloons in ascending order of a key of their targets; those without a place once more when the others
  // have found better ones.
  void add_all(const std::function<double(const Vec2&)>& key) {
    std::vector<std::size_t> order(targets_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(targets_[a].point) < key(targets_[b].point); });
    for (int i = 0; i < 2; ++i) {
      std::vector<std::size_t> without_place;
      for (const std::size_t target : order)
        if (!add(target)) without_place.push_back(target);
      order = std::move(without_place);
      improve();
    }
  }

  // Places every balloon anew beside the others.
  void improve() {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Placed old = placed_.front();
      placed_.erase(placed_.begin());
      if (!add(old.target)) placed_.push_back(old);
    }
  }

  [[nodiscard]] const std::vector<Placed>& placed() const { return placed_; }

 private:
  [[nodiscard]] Vec2 end_of(const Placed& one) const { return leader_end(targets_[one.target], one.place); }

  // Leaders are oblique (ISO 128-2). Beside a text, its end is best.
  [[nodiscard]] double cost_of(const Placed& one) const {
    constexpr double for_ring = 12, for_upright = 15;
    if (const auto& box = targets_[one.target].beside)
      return glm::length(one.place.centre - (box->centre + box->half.x * box->along)) + for_ring * one.place.ring;
    const Vec2 leader = one.place.centre - end_of(one);
    const double least = std::min(std::abs(leader.x), std::abs(leader.y));
    return glm::length(leader) + for_ring * one.place.ring + (least < 0.18 * glm::length(leader) ? for_upright : 0);
  }

  [[nodiscard]] double penalty_of_crossings(const Placed& one) const {
    constexpr double for_crossing = 60;
    const TurnedBox leader = line_box(one.place.centre, end_of(one));
    return for_crossing *
           static_cast<double>(std::count_if(neighbours_.boxes.begin(), neighbours_.boxes.end(),
                                             [&leader](const TurnedBox& box) { return overlap(leader, box); }));
  }

  [[nodiscard]] bool suits(const Placed& one) const {
    const double least = sizes_.radius + sizes_.apart;
    return std::all_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
      const Vec2 &a = one.place.centre, &b = other.place.centre;
      return glm::length(a - b) >= sizes_.radius + least && !do_leaders_cross(a, end_of(one), b, end_of(other)) &&
             distance_to_segment(a, b, end_of(other)) >= least && distance_to_segment(b, a, end_of(one)) >= least;
    });
  }

  std::span<const BalloonTarget> targets_;
  BalloonSizes sizes_;
  const Neighbours& neighbours_;
  std::vector<std::vector<BalloonPlace>> places_;  ///< by target: those that are free
  std::vector<Placed> placed_;
};

void draw(Layer& layer, const BalloonTarget& target, const BalloonPlace& place, const BalloonSizes& sizes,
          const DimensionStyle& style) {
  const Vec2 &centre = place.centre, end = leader_end(target, place);
  layer.strokes.push_back(circle_at(centre, sizes.radius));
  layer.texts.push_back({target.number, centre - Vec2(0, sizes.text / 2), sizes.text, 0, Align::middle, "balloon"});
  if (target.beside && place.ring == 0) return;
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

double balloon_room(double dimension_text) { return first_ring + 2 * balloon_radius(dimension_text) + balloons_apart; }

std::vector<std::string> place_balloons(Layer& layer, std::span<const BalloonTarget> targets,
                                        const drawing::ViewDrawing& view, const DimensionStyle& style,
                                        const Neighbours& neighbours) {
  const BalloonSizes sizes = sizes_of(targets, style);
  const BalloonPlacer empty(targets, view, sizes, neighbours);
  // Usually those near the border of the view first: their leaders are short and leave the others ways between them.
  const auto depth = [&](const Vec2& p) {
    const Vec2 inside = glm::min(p - view.box.min, view.box.max - p);
    return std::min(inside.x, inside.y);
  };
  const std::array<std::function<double(const Vec2&)>, 4> orders = {depth, [&](const Vec2& p) { return -depth(p); },
                                                                    [](const Vec2& p) { return p.x; },
                                                                    [](const Vec2& p) { return p.y; }};
  std::vector<Placed> placed;
  for (const auto& order : orders) {
    BalloonPlacer tried = empty;
    tried.add_all(order);
    if (tried.placed().size() > placed.size()) placed = tried.placed();
    if (placed.size() == targets.size()) break;
  }
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.target < b.target; });
  check(placed.size() <= targets.size(), "every part has one balloon");
  std::vector<std::string> left_out;
  for (std::size_t i = 0, next = 0; i < targets.size(); ++i) {
    if (next < placed.size() && placed[next].target == i)
      draw(layer, targets[i], placed[next++].place, sizes, style);
    else
      left_out.push_back(targets[i].number);
  }
  return left_out;
}

}  // namespace epura::sheet
