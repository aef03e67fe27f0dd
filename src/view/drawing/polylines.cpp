// SPDX-License-Identifier: Apache-2.0
#include "drawing/polylines.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "base/error.hpp"

namespace epura::drawing {

Polylines::Polylines(const std::vector<Piece>& pieces, const std::vector<signed char>& strength,
                     const Progress& progress, double touching) {
  const auto place = [&](End end) { return end % 2 == 0 ? pieces[line_of(end)].from : pieces[line_of(end)].to; };
  const auto look = [&](End end) { return std::array{static_cast<double>(strength[line_of(end)])}; };
  const auto kind = [&](End end) { return pieces[line_of(end)].kind; };
  const std::vector<End> continuation = find_continuations(LineEnds{static_cast<int>(pieces.size()), place, look, kind},
                                                           {.touching = touching}, progress);
  std::vector<char> used(pieces.size(), 0);
  members_.reserve(pieces.size());
  const auto follow = [&](End start, bool closed) {
    Line line{members_.size(), 0, closed, strength[line_of(start)], 0, order_on_page(place(start))};
    for (End at = start; at != no_end && used[line_of(at)] == 0; at = continuation[other(at)]) {
      used[line_of(at)] = 1;
      members_.push_back(at);
      line.length += length_of(pieces[line_of(at)]);
    }
    line.count = members_.size() - line.first;
    check(line.count > 0 && line.length >= 0, "a polyline has pieces");
    lines_.push_back(line);
  };
  const auto last_of = [&](End start) {
    End at = start;
    while (continuation[other(at)] != no_end) at = continuation[other(at)];
    return other(at);
  };
  // Of a ring, the end at its first place from which the next place comes first.
  const auto first_of_ring = [&](End start) {
    const auto rank = [&](End end) { return std::pair(order_on_page(place(end)), order_on_page(place(other(end)))); };
    End first = start;
    End at = start;
    do {
      for (const End end : {at, other(at)})
        if (rank(end) < rank(first)) first = end;
      at = continuation[other(at)];
    } while (at != start);
    return first;
  };
  const auto is_left = [&](End end) { return strength[line_of(end)] >= 0 && used[line_of(end)] == 0; };
  const End ends = static_cast<End>(continuation.size());
  for (End end = 0; end < ends; ++end) {
    if (continuation[end] != no_end || !is_left(end)) continue;
    const End last = last_of(end);
    follow(order_on_page(place(last)) < order_on_page(place(end)) ? last : end, false);
  }
  // The remaining pieces form rings.
  for (End end = 0; end < ends; end += 2)
    if (is_left(end)) follow(first_of_ring(end), true);
}

std::vector<std::size_t> Polylines::by_rank() const {
  std::vector<std::size_t> order(lines_.size());
  std::iota(order.begin(), order.end(), 0);
  // Compared as floats, so that rounding does not decide.
  const auto rank = [&](std::size_t i) {
    const Line& line = lines_[i];
    return std::tuple(-line.strength, -static_cast<float>(line.length), static_cast<float>(line.order),
                      line_of(members_[line.first]), i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

}  // namespace epura::drawing
