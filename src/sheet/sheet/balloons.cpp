// SPDX-License-Identifier: Apache-2.0
#include "sheet/balloons.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

constexpr double first_ring = 7, next_ring = 6;  // mm between the view and the circles, and between rings
constexpr int rings = 9;
constexpr double ring_step = 2;         // mm between possible places on a ring
constexpr double balloons_apart = 2.5;  // mm between circles, and between them and other things

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

double distance_to_line(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double length = glm::dot(along, along);
  const double t = length > 0 ? std::clamp(glm::dot(p - from, along) / length, 0.0, 1.0) : 0;
  return glm::length(p - from - t * along);
}

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

/// Chooses places, one balloon after another.
class BalloonPlacer {
 public:
  BalloonPlacer(std::span<const BalloonTarget> targets, const Rectangle& view, double radius,
                const Neighbours& neighbours)
      : targets_(targets), radius_(radius), neighbours_(neighbours) {
    const auto is_free = [&](const BalloonPlace& place) {
      const Rectangle box{place.centre - radius - balloons_apart, place.centre + radius + balloons_apart};
      if (neighbours.paper && !neighbours.paper->holds(box)) return false;
      const TurnedBox turned = turned_box(box);
      return std::none_of(neighbours.boxes.begin(), neighbours.boxes.end(),
                          [&turned](const TurnedBox& other) { return overlap(turned, other); });
    };
    for (const BalloonPlace& place : places_around(view, radius))
      if (is_free(place)) places_.push_back(place);
  }

  // Adds a balloon where it costs least beside those that are placed; returns false if there is no place.
  bool add(std::size_t target) {
    std::optional<Placed> best;
    double least = HUGE_VAL;
    for (const BalloonPlace& place : places_) {
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
  [[nodiscard]] Vec2 end_of(const Placed& one) const { return targets_[one.target].point; }

  // Leaders are oblique (ISO 128-2).
  [[nodiscard]] double cost_of(const Placed& one) const {
    constexpr double for_ring = 12, for_upright = 15;
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
    const double least = radius_ + balloons_apart;
    return std::all_of(placed_.begin(), placed_.end(), [&](const Placed& other) {
      const Vec2 &a = one.place.centre, &b = other.place.centre;
      return glm::length(a - b) >= radius_ + least && !do_leaders_cross(a, end_of(one), b, end_of(other)) &&
             distance_to_line(a, b, end_of(other)) >= least && distance_to_line(b, a, end_of(one)) >= least;
    });
  }

  std::span<const BalloonTarget> targets_;
  double radius_;
  const Neighbours& neighbours_;
  std::vector<BalloonPlace> places_;
  std::vector<Placed> placed_;
};

void draw(Layer& layer, const BalloonTarget& target, const Vec2& centre, const DimensionStyle& style) {
  const double radius = balloon_radius(style.text), height = balloon_text(style.text);
  const Vec2 along = glm::normalize(target.point - centre);
  layer.strokes.push_back(circle_at(centre, radius));
  layer.strokes.emplace_back().points = {centre + radius * along, target.point};
  layer.fills.push_back(target.on_line ? arrow_at(target.point, along, style) : dot_at(target.point));
  layer.texts.push_back({target.number, centre - Vec2(0, height / 2), height, 0, Align::middle, "balloon"});
}

}  // namespace

double balloon_text(double dimension_text) { return dimension_text < 3 ? 3.5 : 5; }

double balloon_radius(double dimension_text) { return 1.1 * balloon_text(dimension_text); }

double balloon_room(double dimension_text) { return first_ring + 2 * balloon_radius(dimension_text) + balloons_apart; }

std::vector<std::string> place_balloons(Layer& layer, std::span<const BalloonTarget> targets, const Rectangle& view,
                                        const DimensionStyle& style, const Neighbours& neighbours) {
  const BalloonPlacer empty(targets, view, balloon_radius(style.text), neighbours);
  // Usually those near the border of the view first: their leaders are short and leave the others ways between them.
  const auto depth = [&](const Vec2& p) {
    const Vec2 inside = glm::min(p - view.min, view.max - p);
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
      draw(layer, targets[i], placed[next++].place.centre, style);
    else
      left_out.push_back(targets[i].number);
  }
  return left_out;
}

}  // namespace epura::sheet
