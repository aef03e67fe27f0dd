// SPDX-License-Identifier: Apache-2.0
// The order of places for a tree that halves them.
#pragma once

#include <algorithm>
#include <glm/common.hpp>

namespace epura::search {

/// Halves items again and again across the longest side of the box of their places: those of each half lie close
/// together, even if there are many of them anywhere.
template <class Iterator, class PlaceOf>
void order_by_halving(Iterator begin, Iterator end, const PlaceOf& place_of) {
  if (end - begin < 2) return;
  auto min = place_of(*begin), max = min;
  for (auto i = begin; i != end; ++i) {
    min = glm::min(min, place_of(*i));
    max = glm::max(max, place_of(*i));
  }
  const auto size = max - min;
  int longest = 0;
  for (int axis = 1; axis < size.length(); ++axis)
    if (size[axis] > size[longest]) longest = axis;
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end,
                   [&](const auto& a, const auto& b) { return place_of(a)[longest] < place_of(b)[longest]; });
  order_by_halving(begin, middle, place_of);
  order_by_halving(middle, end, place_of);
}

}  // namespace epura::search
