// SPDX-License-Identifier: Apache-2.0
// Finds which lines continue each other where several straight lines meet in a point.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

/// Joins ends that meet in one point, the straightest pair first, while there are two left.
template <class Place>
void pair_up(const Place& place, std::span<const End> ends, std::vector<End>& partner) {
  constexpr std::size_t most_at_a_point = 64;  // beyond that, straightness is not worth a quadratic search
  if (ends.size() > most_at_a_point) return;
  const auto join = [&](End a, End b) {
    partner[a] = b;
    partner[b] = a;
  };
  if (ends.size() == 2) return join(ends[0], ends[1]);
  std::vector<std::pair<End, Vec2>> left;  // with the direction in which the line leaves that end
  for (const End end : ends) left.emplace_back(end, glm::normalize(place(other(end)) - place(end)));
  while (left.size() >= 2) {
    std::tuple<double, End, End> best{HUGE_VAL, no_end, no_end};
    for (std::size_t i = 0; i < left.size(); ++i)
      for (std::size_t j = i + 1; j < left.size(); ++j)
        best = std::min(best, std::tuple(glm::dot(left[i].second, left[j].second), left[i].first, left[j].first));
    const auto [straightness, a, b] = best;
    join(a, b);
    std::erase_if(left, [a = a, b = b](const auto& l) { return l.first == a || l.first == b; });
  }
}

/// Returns for each end the end that continues it, or none. `place(end)` is its position, mm; `look(end)` is an array
/// of doubles that two ends must have in common to be joined. Throws OutOfTime.
template <class Place, class Look>
std::vector<End> find_partners(int lines, const Place& place, const Look& look, const Progress& progress) {
  std::vector<End> partner(static_cast<std::size_t>(lines) * 2, no_end);
  // Where lines of two faces coincide, parts of both are drawn, with ends that differ by rounding: about 1e-13 mm.
  const auto rounded = [](double x) { return std::round(x * 0x1p30); };
  const auto key = [&](End end) {
    const auto of_look = look(end);
    const Vec2& p = place(end);
    std::array<double, of_look.size() + 2> all{rounded(p.x), rounded(p.y)};
    std::copy(of_look.begin(), of_look.end(), all.begin() + 2);
    return all;
  };
  visit_same_keys(2 * lines, key, progress, [&](std::span<const End> ends) { pair_up(place, ends, partner); });
  return partner;
}

}  // namespace epura::drawing
