// SPDX-License-Identifier: Apache-2.0
#include "study/methods/rounded_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/parallel.hpp"

namespace epura::study {

namespace {

constexpr int usual_bits = 30;
constexpr double forgiven = 4;
// Half a unit in the last place of floats near 1.
constexpr double float_rounding = 0x1p-24;
constexpr std::size_t grain = 8192;

view::ProjectedScene copy_for_visibility(const view::ProjectedScene& view) {
  view::ProjectedScene copy;
  copy.middle = view.middle;
  copy.extent = view.extent;
  copy.cell = view.cell;
  copy.contact = view.contact;
  copy.vertices = view.vertices;
  copy.grid.resize(view.grid.size());
  copy.triangles = view.triangles;
  return copy;
}

// Vertices that no triangle and no edge uses may lie anywhere; rounding may move others beyond the end of the grid.
void lay_on_grid(view::ProjectedScene& view, int bits) {
  const double half = std::ldexp(1.0, bits);
  const auto to_grid = [&](double cells) {
    if (!(std::abs(cells) <= 2 * half)) return 0;
    return static_cast<std::int32_t>(std::nearbyint(std::clamp(cells, 1 - half, half - 1)));
  };
  parallel_for(view.vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      view.grid[v] = {to_grid(view.vertices[v].x / view.cell), to_grid(view.vertices[v].y / view.cell)};
  });
}

}  // namespace

view::ProjectedScene on_coarser_grid(const view::ProjectedScene& view, int bits) {
  view::ProjectedScene rounded = copy_for_visibility(view);
  rounded.cell = std::ldexp(view.cell, usual_bits - bits);
  rounded.contact.touching = std::max(view.contact.touching, forgiven * rounded.cell);
  lay_on_grid(rounded, bits);
  return rounded;
}

view::ProjectedScene in_floats(const view::ProjectedScene& view) {
  view::ProjectedScene rounded = copy_for_visibility(view);
  const double rounding = forgiven * float_rounding * view.extent;
  rounded.contact.touching = std::max(view.contact.touching, rounding);
  rounded.contact.joined = std::max(view.contact.joined, rounding);
  for (view::PageVertex& v : rounded.vertices)
    v = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.depth), v.w};
  lay_on_grid(rounded, usual_bits);
  return rounded;
}

}  // namespace epura::study
