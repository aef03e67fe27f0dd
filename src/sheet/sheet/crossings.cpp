// SPDX-License-Identifier: Apache-2.0
#include "sheet/crossings.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "drawing/chain_lines.hpp"
#include "drawing/drawing.hpp"
#include "search/choose_grid.hpp"

namespace epura::sheet {

namespace {

constexpr double touching = 1e-6;  // mm

// Where b meets a, as a distance along a; nothing if they are parallel or do not meet.
std::optional<double> meeting(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  const Vec2 a = a1 - a0, b = b1 - b0;
  const double length = glm::length(a), other = glm::length(b), area = cross(a, b);
  constexpr double sine = 1e-3;
  if (!(std::abs(area) > sine * length * other)) return std::nullopt;
  const double s = cross(b0 - a0, b) / area, t = cross(b0 - a0, a) / area;
  if (s * length < -touching || (s - 1) * length > touching) return std::nullopt;
  if (t * other < -touching || (t - 1) * other > touching) return std::nullopt;
  return std::clamp(s, 0.0, 1.0) * length;
}

constexpr std::size_t grain = 1024;

}  // namespace

Crossings::Crossings(std::span<const drawing::Chain> chains, std::vector<std::size_t> asked, const Progress& progress)
    : chains_(chains), asked_(std::move(asked)) {
  if (asked_.empty()) return;
  for (std::size_t i = 0; i < chains.size(); ++i)
    if (!edges::is_within_surface(chains[i].kind))
      drawing::visit_lines(chains[i], [&](const Vec2& from, const Vec2& to) { lines_.push_back({from, to, i}); });
  // At most one cell for each line, and not so many that lines would pass through too many of them.
  grid_ = search::grid_over_lines(lines_, {static_cast<double>(lines_.size()), 1e-3, 8, 0});
  fill(wanted_cells(progress), progress);
}

// The cells that are needed: those along the requested chains.
std::vector<char> Crossings::wanted_cells(const Progress& progress) const {
  std::vector<char> cells(static_cast<std::size_t>(grid_.count()), 0);
  parallel_for(asked_.size(), grain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      drawing::visit_lines(chains_[asked_[i]], [&](const Vec2& from, const Vec2& to) {
        search::visit_cells(grid_, from, to, touching, [&](int cell, double, double) {
          std::atomic_ref(cells[cell]).store(1, std::memory_order_relaxed);
        });
      });
  });
  return cells;
}

void Crossings::fill(const std::vector<char>& wanted, const Progress& progress) {
  lines_of_cells_ = Groups<int>(wanted.size(), [&](const auto& add) {
    parallel_for(lines_.size(), grain, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        search::visit_cells(grid_, lines_[i].from, lines_[i].to, touching, [&](int cell, double, double) {
          if (wanted[cell] != 0) add(static_cast<std::size_t>(cell), static_cast<int>(i));
        });
    });
  });
}

bool Crossings::has_outline_at(const Vec2& point) const {
  if (asked_.empty()) return false;
  const int cell = grid_.cell(grid_.column(point.x), grid_.row(point.y));
  const std::span<const int> lines = lines_of_cells_[static_cast<std::size_t>(cell)];
  return std::any_of(lines.begin(), lines.end(), [&](int number) {
    const Line& line = lines_[number];
    return chains_[line.chain].visible && distance_to_segment(point, line.from, line.to) < touching;
  });
}

std::vector<double> Crossings::along(std::size_t chain, double apart) const {
  std::vector<double> found;
  if (!std::binary_search(asked_.begin(), asked_.end(), chain)) return found;
  double travelled = 0;
  drawing::visit_lines(chains_[chain], [&](const Vec2& from, const Vec2& to) {
    search::visit_cells(grid_, from, to, touching, [&](int cell, double, double) {
      for (const int number : lines_of_cells_[static_cast<std::size_t>(cell)]) {
        const Line& line = lines_[number];
        if (line.chain == chain) continue;
        if (const auto at = meeting(from, to, line.from, line.to)) found.push_back(travelled + *at);
      }
    });
    travelled += glm::distance(from, to);
  });
  std::sort(found.begin(), found.end());
  check(found.empty() || (found.front() >= 0 && found.back() <= travelled * (1 + 1e-9)), "lines cross on the line");
  double last = -HUGE_VAL;
  std::erase_if(found, [&](double at) {
    if (at - last < apart) return true;
    last = at;
    return false;
  });
  return found;
}

}  // namespace epura::sheet
