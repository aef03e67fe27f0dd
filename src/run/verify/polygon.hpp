// SPDX-License-Identifier: Apache-2.0
// Small convex polygons and their intersection with half-spaces.
#pragma once

#include <array>
#include <cstddef>

#include "base/error.hpp"
#include "verify/numbers.hpp"

namespace epura::verify {

/// The corners of a convex polygon in space: a triangle cut by at most eight planes.
template <class N>
struct Polygon {
  std::array<Triple<N>, 12> corner;
  std::size_t count = 0;

  void add(const Triple<N>& p) {
    check(count < corner.size(), "a polygon has at most twelve corners");
    corner[count++] = p;
  }
};

/// Returns the part where `height`, an affine function, is not negative (Sutherland & Hodgman, CACM 1974).
template <class N, class Height>
Polygon<N> clip(const Polygon<N>& polygon, const Height& height) {
  Polygon<N> rest;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Triple<N>& from = polygon.corner[i];
    const Triple<N>& to = polygon.corner[(i + 1) % polygon.count];
    const N at_from = height(from), at_to = height(to);
    if (at_from >= 0) rest.add(from);
    if ((at_from >= 0) != (at_to >= 0)) {
      const N part = at_from / (at_from - at_to);
      rest.add(along<N>(from, part, to - from));
    }
  }
  return rest;
}

}  // namespace epura::verify
