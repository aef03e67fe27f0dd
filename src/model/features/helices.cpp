// SPDX-License-Identifier: Apache-2.0
#include "features/helices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "base/portable_math.hpp"
#include "features/limits.hpp"
#include "scene/standard_threads.hpp"

namespace epura::features {

namespace {

Vec2 on_circle(double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {portable_cos(angle), portable_sin(angle)};
}

Vec2 turned(const Vec2& place, const Vec2& by) {
  return {place.x * by.x - place.y * by.y, place.x * by.y + place.y * by.x};
}

// The resultant of the places of points along a right- or left-handed helix.
double order_along(const TurnsAndHeights& points, double pitch, bool left) {
  Vec2 sum(0);
  for (const Vec2& at : points) sum += on_circle(at.y / pitch + (left ? at.x : -at.x));
  return glm::length(sum) / static_cast<double>(points.size());
}

// The fewest turns, in steps, with which points are in order along a helix of this length. A step turns each place by
// what the point's height is, so that no angle is computed twice.
std::optional<double> fewest_turns(const TurnsAndHeights& points, double length) {
  struct Place {
    Vec2 at, step, around;
  };
  std::vector<Place> places;
  for (const Vec2& p : points) {
    const Vec2 step = on_circle(pitch_step * p.y / length);
    places.push_back({step, step, on_circle(p.x)});
  }
  const auto count = static_cast<double>(points.size());
  for (double turns = pitch_step; turns <= count / points_of_turn; turns += pitch_step) {
    Vec2 left(0), right(0);
    for (Place& place : places) {
      left += turned(place.at, place.around);
      right += turned(place.at, {place.around.x, -place.around.y});
      place.at = turned(place.at, place.step);
    }
    if (std::max(glm::length(left), glm::length(right)) >= min_order * count) return turns;
  }
  return std::nullopt;
}

// Whether crests are a left-handed helix; nothing if they are none. Where a thread runs out into a shaft at one end or
// both, within two turns, all is as far from the axis as the crests.
std::optional<bool> is_left_handed(const Crests& crests, double pitch) {
  for (const double cut : {0, 1, 2}) {
    const double from = crests.heights.from + cut * pitch, to = crests.heights.to - cut * pitch;
    if (to - from < min_turns * pitch) break;
    TurnsAndHeights some;
    for (const Vec2& at : crests.points)
      if (at.y >= from && at.y <= to) some.push_back(at);
    if (some.empty() || !goes_around(some)) break;
    const double turns = (to - from) / pitch;
    for (const bool left : {false, true}) {
      const double order = order_along(some, pitch, left);
      // A few turns suit a pitch about as large, too, but less than their own.
      const auto suits_better = [&](double more) {
        return cut > 0 && order_along(some, (to - from) / (turns + more), left) > order;
      };
      if (order >= min_order && !suits_better(turns_off) && !suits_better(-turns_off)) return left;
    }
  }
  return std::nullopt;
}

}  // namespace

std::size_t scattered(std::size_t i, std::size_t count) {
  const double turns = (std::numbers::phi - 1) * static_cast<double>(i), place = turns - std::floor(turns);
  return static_cast<std::size_t>(place * static_cast<double>(count));
}

bool goes_around(TurnsAndHeights points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
  double gap = points.front().x + 1 - points.back().x;
  for (std::size_t i = 1; i < points.size(); ++i) gap = std::max(gap, points[i].x - points[i - 1].x);
  return gap <= widest_gap / 360;
}

std::optional<scene::Thread> best_size(const Crests& crests, double unit) {
  const double diameter = 2 * crests.radius * unit;
  std::optional<scene::Thread> best;
  double least = HUGE_VAL;
  for (const scene::Thread& thread : scene::threads_between(diameter / scene::largest_shaft, 1.5 * diameter + 1)) {
    if (!scene::suits(thread, diameter, crests.internal) || crests.heights.size() * unit < min_turns * thread.pitch)
      continue;
    const auto left = is_left_handed(crests, thread.pitch / unit);
    if (!left) continue;
    const double off = std::abs((crests.internal ? thread.minor() : thread.diameter) - diameter);
    if (off >= least) continue;
    best = thread;
    if (*left) best->text += "-LH";
    least = off;
  }
  return best;
}

std::optional<double> pitch_of(const Crests& crests) {
  const TurnsAndHeights& all = crests.points;
  if (all.size() < fewest_helix_points) return std::nullopt;
  TurnsAndHeights some;
  for (std::size_t i = 0; i < std::min(max_helix_samples, all.size()); ++i)
    some.push_back(all[scattered(i, all.size())]);
  const double length = crests.heights.size();
  const auto order = [length](const TurnsAndHeights& points, double turns) {
    return std::max(order_along(points, length / turns, true), order_along(points, length / turns, false));
  };
  const std::optional<double> fewest = fewest_turns(some, length);
  if (!fewest) return std::nullopt;
  double turns = *fewest;
  while (order(some, turns + pitch_step) > order(some, turns)) turns += pitch_step;
  double from = turns - pitch_step, to = turns + pitch_step;
  while (to - from > 1e-6 * turns) {
    const double low = from + (to - from) / 3, high = to - (to - from) / 3;
    const bool is_above = order(all, low) < order(all, high);
    (is_above ? from : to) = is_above ? low : high;
  }
  const double found = (from + to) / 2;
  return found < min_turns ? std::nullopt : std::optional(length / found);
}

}  // namespace epura::features
