// SPDX-License-Identifier: Apache-2.0
#include "drawing/measured_polyline.hpp"

#include <algorithm>

namespace epura::drawing {

std::size_t MeasuredPolyline::member_at(double x) const {
  const auto found = std::upper_bound(members_.begin(), members_.end(), x,
                                      [](double value, const Member& member) { return value < member.to; });
  return std::min(static_cast<std::size_t>(found - members_.begin()), members_.size() - 1);
}

Vec2 MeasuredPolyline::place(std::size_t member, double x) const {
  const InkPart part = part_of({member, x, x});
  return place_on((*pieces_)[part.piece], part.from);
}

InkPart MeasuredPolyline::part_of(const Stretch& stretch) const {
  const Member& member = members_[stretch.member];
  const auto u = [&](double x) {
    return x <= member.from ? 0.0 : x >= member.to ? 1.0 : (x - member.from) / (member.to - member.from);
  };
  const double from = u(stretch.from), to = u(stretch.to);
  if (member.end % 2 == 0) return {line_of(member.end), from, to};
  return {line_of(member.end), 1 - to, 1 - from};
}

Vec2 MeasuredPolyline::direction_of(std::size_t member, double with_direction, double touching) const {
  const Member& own = members_[member];
  const Vec2 step = place(member, own.to) - place(member, own.from);
  const double half = with_direction / 2, middle = (own.from + own.to) / 2;
  if (own.to - own.from >= 2 * half) return glm::normalize(step);
  const Vec2 around = place(std::min(middle + half, length())) - place(std::max(middle - half, 0.0));
  return glm::normalize(glm::dot(around, around) > touching * touching ? around : step);
}

}  // namespace epura::drawing
