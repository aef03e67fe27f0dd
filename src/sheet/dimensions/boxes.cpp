#include "sheet/dimensions/boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epura {

namespace {

constexpr double border = 1e-6;  // mm

Vec2 left_of(const Vec2& d) { return {-d.y, d.x}; }

// Half the length of the box's shadow on a line.
double half_shadow(const TurnedBox& box, const Vec2& line) {
  return box.half.x * std::abs(glm::dot(box.along, line)) + box.half.y * std::abs(glm::dot(left_of(box.along), line));
}

// Half the size of the upright box around it.
Vec2 upright_half(const TurnedBox& box) { return {half_shadow(box, {1, 0}), half_shadow(box, {0, 1})}; }

}  // namespace

TurnedBox line_box(const Vec2& from, const Vec2& to) {
  const double length = glm::length(to - from);
  return {(from + to) * 0.5, length > 0 ? (to - from) / length : Vec2(1, 0), {length / 2, 0}};
}

// Two convex figures are apart if and only if their shadows on a line square to one of their sides are.
bool overlap(const TurnedBox& a, const TurnedBox& b) {
  const std::array<Vec2, 4> lines{a.along, left_of(a.along), b.along, left_of(b.along)};
  return std::none_of(lines.begin(), lines.end(), [&](const Vec2& line) {
    return std::abs(glm::dot(a.centre - b.centre, line)) >= half_shadow(a, line) + half_shadow(b, line) - border;
  });
}

int overlaps(const TurnedBox& box, std::span<const TurnedBox> others) {
  return static_cast<int>(
      std::count_if(others.begin(), others.end(), [&box](const TurnedBox& other) { return overlap(box, other); }));
}

int ink_in(const TurnedBox& box, const Drawing& drawing) {
  const Vec2 half = upright_half(box);
  const Vec2 least = box.centre - half, most = box.centre + half;
  return static_cast<int>(std::count_if(drawing.segments.begin(), drawing.segments.end(), [&](const Segment& s) {
    if (std::max(s.from.x, s.to.x) < least.x || std::min(s.from.x, s.to.x) > most.x) return false;
    if (std::max(s.from.y, s.to.y) < least.y || std::min(s.from.y, s.to.y) > most.y) return false;
    return overlap(box, line_box(s.from, s.to));
  }));
}

}  // namespace epura
