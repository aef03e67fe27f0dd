// SPDX-License-Identifier: Apache-2.0
// Finds which lines continue each other where several straight lines meet in a point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "base/same_key.hpp"
#include "base/vec.hpp"

namespace epura::drawing {

/// One end of a line: 2 * line + (0 for its start, 1 for its end).
using End = int;
inline constexpr End no_end = -1;

constexpr int line_of(End end) { return end / 2; }
constexpr End other(End end) { return end ^ 1; }

/// Lines whose ends are to be joined. `place(end)` is the position of an end, mm; `look(end)` an array of doubles that
/// two ends must have in common; `kind(end)` tells which of them belong together most.
template <class Place, class Look, class Kind>
struct LineEnds {
  int lines;
  Place place;
  Look look;
  Kind kind;
};
template <class Place, class Look, class Kind>
LineEnds(int, Place, Look, Kind) -> LineEnds<Place, Look, Kind>;

/// Joins the only two ends that meet in a point.
inline void pair_up(End a, End b, std::vector<End>& partner) {
  if (a == other(b)) return;
  partner[a] = b;
  partner[b] = a;
}

/// Joins ends that meet in one point, while there are two left: first those that go on in nearly the same direction,
/// as facets of a curve do, then those of one kind; the straightest pair first. Of pairs that are about as straight,
/// one of one kind is preferred: a curve that touches another leaves it a little straighter than it goes on itself.
template <class Ends>
void pair_up(const Ends& lines, std::span<const End> ends, std::vector<End>& partner) {
  constexpr std::size_t most_at_a_point = 64;  // beyond that, straightness is not worth a quadratic search
  constexpr double going_on = -0.75;           // cosine between the directions in which the lines leave the point
  constexpr double about = 0.02;               // difference of such cosines
  if (ends.size() > most_at_a_point) return;
  std::vector<std::pair<End, Vec2>> left;  // with the direction in which the line leaves that end
  for (const End end : ends)
    if (partner[end] == no_end) left.emplace_back(end, glm::normalize(lines.place(other(end)) - lines.place(end)));
  using Pair = std::tuple<bool, double, End, End>;
  while (left.size() >= 2) {
    Pair best{true, HUGE_VAL, no_end, no_end};
    for (std::size_t i = 0; i < left.size(); ++i)
      for (std::size_t j = i + 1; j < left.size(); ++j) {
        const auto& [a, direction_a] = left[i];
        const auto& [b, direction_b] = left[j];
        const double straightness = glm::dot(direction_a, direction_b);
        const bool differ = lines.kind(a) != lines.kind(b), is_corner = straightness > going_on && differ;
        if (a != other(b)) best = std::min(best, Pair(is_corner, straightness + (differ ? about : 0), a, b));
      }
    const End a = std::get<2>(best), b = std::get<3>(best);
    if (a == no_end) return;
    partner[a] = b;
    partner[b] = a;
    std::erase_if(left, [a, b](const auto& l) { return l.first == a || l.first == b; });
  }
}

/// Returns for each end the end that continues it, or none. Ends up to `touching` mm apart meet if they meet no nearer
/// one. Throws OutOfTime.
template <class Ends>
std::vector<End> find_partners(const Ends& lines, double touching, const Progress& progress) {
  std::vector<End> partner(static_cast<std::size_t>(lines.lines) * 2, no_end);
  std::vector<End> alone(partner.size());
  std::iota(alone.begin(), alone.end(), 0);
  const auto join = [&](double cell, const Vec2& shift) {
    const auto key = [&](int number) {
      const auto look = lines.look(alone[number]);
      const Vec2 at = lines.place(alone[number]) / cell + shift;
      std::array<double, look.size() + 2> all{std::round(at.x), std::round(at.y)};
      std::copy(look.begin(), look.end(), all.begin() + 2);
      return all;
    };
    visit_same_keys(static_cast<int>(alone.size()), key, progress, [&](std::span<const int> numbers) {
      if (numbers.size() == 2) return pair_up(alone[numbers[0]], alone[numbers[1]], partner);
      std::vector<End> ends;
      for (const int number : numbers) ends.push_back(alone[number]);
      pair_up(lines, ends, partner);
    });
    std::erase_if(alone, [&](End end) { return partner[end] != no_end; });
  };
  // Where lines of two faces coincide, parts of both are drawn, with ends that differ by rounding: about 1e-13 mm.
  join(0x1p-30, Vec2(0));
  if (!(touching > 0x1p-30)) return partner;
  // Of four grids with cells of twice that distance, one has both ends in one cell.
  for (const double x : {0.0, 0.5})
    for (const double y : {0.0, 0.5}) join(2 * touching, Vec2(x, y));
  return partner;
}

}  // namespace epura::drawing
