// SPDX-License-Identifier: Apache-2.0
#include "sheet/ink_density.hpp"

#include <atomic>
#include <cmath>
#include <cstddef>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/chain_lines.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double nanometres = 1e6;  // per millimetre

search::CellGrid grid_over(std::span<const drawing::Chain> chains, double side) {
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  for (const drawing::Chain& chain : chains)
    for (const Vec2& point : chain.points) {
      min = glm::min(min, point);
      max = glm::max(max, point);
    }
  if (!(min.x <= max.x)) return {Vec2(0), Vec2(side), 1, 1};
  // Ink may lie far outside the paper.
  constexpr double max_cells = 1024;
  const Vec2 size = max - min;
  const Vec2 sides = glm::max(Vec2(side), size / max_cells);
  // Offset from lines at round distances: a line along a cell border would count on both sides of it.
  return {min - 0.3 * sides, sides, static_cast<int>(size.x / sides.x) + 2, static_cast<int>(size.y / sides.y) + 2};
}

/// Calls visit(cell, length) for the part of each line of a chain in each cell.
template <class Visit>
void visit_parts(const search::CellGrid& grid, const drawing::Chain& chain, const Visit& visit) {
  drawing::visit_lines(chain, [&](const Vec2& from, const Vec2& to) {
    const double length = glm::distance(from, to);
    search::visit_cells(grid, from, to, 0, [&](int cell, double s, double t) { visit(cell, (t - s) * length); });
  });
}

}  // namespace

InkDensity::InkDensity(std::span<const drawing::Chain> chains, double cell_side, const Progress& progress)
    : grid_(grid_over(chains, cell_side)), ink_(static_cast<std::size_t>(grid_.count()), 0) {
  parallel_for(chains.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (edges::is_within_surface(chains[i].kind)) continue;
      visit_parts(grid_, chains[i], [&](int cell, double length) {
        std::atomic_ref(ink_[cell]).fetch_add(std::llround(length * nanometres), std::memory_order_relaxed);
      });
    }
  });
}

double InkDensity::along(const drawing::Chain& chain) const {
  double all = 0, inked = 0;
  visit_parts(grid_, chain, [&](int cell, double length) {
    all += length;
    inked += length * static_cast<double>(ink_[cell]) / nanometres;
  });
  check(inked >= 0, "ink has a length");
  return all > 0 ? inked / (all * grid_.side.x * grid_.side.y) : 0;
}

}  // namespace epura::sheet
