// SPDX-License-Identifier: Apache-2.0
#include "sheet/free_rectangles.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

// The parts left of, right of, below and above the taken rectangle.
std::array<Rectangle, 4> rest_around(const Rectangle& whole, const Rectangle& taken) {
  std::array<Rectangle, 4> parts = {whole, whole, whole, whole};
  parts[0].max.x = taken.min.x;
  parts[1].min.x = taken.max.x;
  parts[2].max.y = taken.min.y;
  parts[3].min.y = taken.max.y;
  return parts;
}

bool has_area(const Rectangle& r) { return r.size().x > 0 && r.size().y > 0; }

}  // namespace

std::vector<Rectangle> free_rectangles(const Rectangle& room, std::span<const Rectangle> taken) {
  std::vector<Rectangle> free = {room};
  for (const Rectangle& obstacle : taken) {
    std::vector<Rectangle> kept, parts;
    for (const Rectangle& r : free) {
      if (!r.overlaps(obstacle)) {
        kept.push_back(r);
        continue;
      }
      for (const Rectangle& part : rest_around(r, obstacle))
        if (has_area(part)) parts.push_back(part);
    }
    // Only new parts can lie in another rectangle: the kept ones were already maximal.
    const auto lies_in = [](const Rectangle& part) { return [&part](const Rectangle& r) { return r.holds(part); }; };
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      const bool in_kept = std::any_of(kept.begin(), kept.end(), lies_in(*part));
      if (!in_kept && std::none_of(part + 1, parts.end(), lies_in(*part))) kept.push_back(*part);
    }
    free = kept;
  }
  for (const Rectangle& r : free) check(room.holds(r), "what is free lies in the room");
  return free;
}

std::optional<Vec2> nearest_free_position(const Rectangle& room, std::span<const Rectangle> taken, const Vec2& size,
                                          const Vec2& towards) {
  constexpr double apart = 3;
  std::vector<Rectangle> grown;
  for (const Rectangle& one : taken) grown.push_back(one.grown(apart));
  std::optional<Vec2> best;
  for (const Rectangle& free : free_rectangles(room.grown(-apart), grown)) {
    if (free.size().x < size.x || free.size().y < size.y) continue;
    const Vec2 corner = glm::clamp(towards - size / 2.0, free.min, free.max - size);
    const auto distance = [&](const Vec2& p) { return glm::length(p + size / 2.0 - towards); };
    if (!best || distance(corner) < distance(*best)) best = corner;
  }
  return best;
}

}  // namespace epura::sheet
