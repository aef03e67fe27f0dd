// SPDX-License-Identifier: Apache-2.0
#include "view/page_height.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura::view {

double grid_resolution(const ProjectedScene& view) {
  // Both ends of a line and the point compared with it were rounded to the grid.
  constexpr double cells = 2;
  return cells * view.cell;
}

double page_resolution(const world::World& world, const ProjectedScene& view) {
  const double resolution = std::max(grid_resolution(view), world.rounding * view.map.normalisation * view.map.unit);
  check(resolution > 0, "a page has a resolution");
  return resolution;
}

double height_on_page(const ProjectedScene& view, const std::array<int, 3>& corners) {
  std::array<Vec2, 3> p{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(view.clipper.vertices[corners[i]].w > 0)) return NAN;
    p[i] = view.vertices[corners[i]].at();
  }
  const Vec2 ab = p[1] - p[0], ac = p[2] - p[0];
  const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
  return longest > 0 ? std::abs(epura::cross(ab, ac)) / longest : 0;
}

}  // namespace epura::view
