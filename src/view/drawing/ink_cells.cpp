// SPDX-License-Identifier: Apache-2.0
#include "drawing/ink_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

// What a search mostly finds, at most.
constexpr std::size_t found_mostly = 64;

constexpr int sectors = 32;

}  // namespace

int sector_of(const Vec2& direction) {
  // Increases with the angle, from 0 to 2 over half a turn.
  const double along = direction.x / (std::abs(direction.x) + std::abs(direction.y));
  const double turn = 1 - (direction.y < 0 ? -along : along);
  return std::min(static_cast<int>(turn * (sectors / 2)), sectors - 1);
}

Sectors sectors_around(const Vec2& direction) {
  const double cosine = along_cosine - on_line_part, sine = std::sqrt(1 - cosine * cosine);
  const auto [x, y] = std::array{direction.x, direction.y};
  const int last = sector_of({cosine * x - sine * y, sine * x + cosine * y});
  Sectors found = Sectors{1} << last;
  for (int at = sector_of({cosine * x + sine * y, cosine * y - sine * x}); at != last; at = (at + 1) % sectors)
    found |= Sectors{1} << at;
  return found;
}

InkCells::InkCells(const Vec2& min, const Vec2& max, double least) {
  const double extent = std::max(max.x - min.x, max.y - min.y);
  double side = std::max(least, extent / max_columns);
  std::vector<double> sides{side};
  while (side < extent) sides.push_back(side *= 2);
  // The cells do not depend on the position of other ink.
  const Vec2 origin = glm::floor(min / side) * side;
  for (const double width : sides) {
    const auto count = [&](double length) { return std::max(1, static_cast<int>(std::ceil(length / width))); };
    Level level{{origin, Vec2(width), count(max.x - origin.x), count(max.y - origin.y)}, 0, {}};
    level.tile_columns = (level.grid.columns + tile_side - 1) / tile_side;
    levels_.push_back(std::move(level));
  }
}

std::vector<int> InkCells::find(const Vec2& from, const Vec2& to, double margin, Sectors wanted) const {
  std::vector<int> found = find_in_any_order(from, to, margin, wanted);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  check(found.empty() || (found.front() >= 0 && found.back() < count_), "cells hold parts");
  return found;
}

std::vector<int> InkCells::find_in_any_order(const Vec2& from, const Vec2& to, double margin, Sectors wanted) const {
  // Nearly all the time is spent waiting for memory. It is therefore asked for in all cells before the first is opened.
  std::vector<int> clusters, found;
  clusters.reserve(found_mostly);
  found.reserve(found_mostly);
  const auto ask_for = [&](int cluster) {
    if (cluster == none) return;
    __builtin_prefetch(&clusters_[cluster]);
    clusters.push_back(cluster);
  };
  for (const Level& level : levels_)
    if (level.used)
      visit_cells(level, from, to, margin, [&](int column, int row) { ask_for(head(level, column, row)); });
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const Cluster& cluster = clusters_[clusters[i]];
    ask_for(cluster.next);
    for (int at = 0; at < cluster.count; ++at)
      if ((wanted >> cluster.sector[at] & 1) != 0) found.push_back(cluster.part[at]);
  }
  check(count_ > 0 || found.empty(), "cells hold parts");
  return found;
}

void InkCells::add(const Vec2& from, const Vec2& to, int sector) {
  const double length = glm::distance(from, to);
  std::size_t level = 0;
  while (level + 1 < levels_.size() && length > cells_a_part * levels_[level].grid.side.x) ++level;
  Level& own = levels_[level];
  if (!own.used) own.tiles.assign(tile_of(own, 0, own.grid.rows - 1) + own.tile_columns, none);
  own.used = true;
  visit_cells(own, from, to, 0, [&](int column, int row) {
    int& tile = own.tiles[tile_of(own, column, row)];
    if (tile < 0) {
      tile = static_cast<int>(heads_.size());
      heads_.resize(heads_.size() + tile_side * tile_side, none);
    }
    int& head = heads_[tile + cell_in_tile(column, row)];
    if (head < 0 || clusters_[head].count == Cluster::most) {
      clusters_.push_back({head, {}, {}, 0});
      head = static_cast<int>(clusters_.size()) - 1;
    }
    Cluster& cluster = clusters_[head];
    cluster.part[cluster.count] = count_;
    cluster.sector[cluster.count] = static_cast<std::uint8_t>(sector);
    ++cluster.count;
  });
  ++count_;
  check(heads_.size() % (tile_side * tile_side) == 0, "tiles are whole");
}

}  // namespace epura::drawing
