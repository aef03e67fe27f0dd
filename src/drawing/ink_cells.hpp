// SPDX-License-Identifier: Apache-2.0
// A growing set of line pieces, searched by position.
//
// A piece is entered into the cells that it crosses, in a grid whose cells are about as large as the piece is long, so
// their number is small for any length. Grids take memory only where they have pieces: their cells are allocated in
// square tiles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "search/line_cells.hpp"

namespace epura::drawing {

/// Directions without a sense, in 32 sectors: a bit for each.
using Sectors = std::uint32_t;

/// Where a direction lies.
int sector_of(const Vec2& direction);

/// All in which directions within 25 degrees of this one lie.
Sectors sectors_around(const Vec2& direction);

class InkCells {
 public:
  /// All lines lie in the box; those up to about `least` mm stand in the finest grid.
  InkCells(const Vec2& min, const Vec2& max, double least);

  /// The part's number is that of the parts that came before it. `sector` is that of the direction it counts for.
  void add(const Vec2& from, const Vec2& to, int sector = 0);
  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Calls `visit(part)` for all parts within `margin` of a line, for some others near it, and perhaps for some more
  /// than once, until it returns false. Only those in `sectors` if it is given. The order is always the same.
  template <class Visit>
  void visit(const Vec2& from, const Vec2& to, double margin, const Visit& visit, Sectors sectors = ~Sectors{}) const {
    bool wanted = true;
    for (std::size_t level = 0; level < levels_.size() && wanted; ++level) {
      const Level& own = levels_[level];
      if (!own.used) continue;
      visit_cells(own, from, to, margin, [&](int column, int row) {
        for (int i = wanted ? head(own, column, row) : none; i >= 0 && wanted; i = clusters_[i].next) {
          const Cluster& cluster = clusters_[i];
          for (int at = cluster.count - 1; at >= 0 && wanted; --at)
            if ((sectors >> cluster.sector[at] & 1) != 0) wanted = visit(cluster.part[at]);
        }
      });
    }
  }

 private:
  struct Level {
    search::CellGrid grid;
    int tile_columns;
    std::vector<int> tiles;  ///< where the cells of each begin in `heads_`, or none
    bool used = false;
  };
  /// Some parts of a cell in half a line of the cache, and where those before them are.
  struct Cluster {
    static constexpr int most = 5;
    int next;
    std::array<int, most> part;
    std::array<std::uint8_t, most> sector;
    std::uint8_t count;
  };
  static constexpr int none = -1;
  static constexpr int tile_bits = 4, tile_side = 1 << tile_bits;  ///< cells

  // Most lines lie in one cell of most grids.
  template <class Visit>
  static void visit_cells(const Level& level, const Vec2& from, const Vec2& to, double margin, const Visit& visit) {
    const search::CellGrid& grid = level.grid;
    const double slack = margin + grid.side.x * 0x1p-20;  // that of the search
    const int column = grid.column(std::min(from.x, to.x) - slack), row = grid.row(std::min(from.y, to.y) - slack);
    if (grid.column(std::max(from.x, to.x) + slack) == column && grid.row(std::max(from.y, to.y) + slack) == row)
      return visit(column, row);
    search::visit_cells(grid, from, to, margin,
                        [&](int cell, double, double) { visit(cell % grid.columns, cell / grid.columns); });
  }

  [[nodiscard]] static std::size_t tile_of(const Level& level, int column, int row) {
    return static_cast<std::size_t>(row >> tile_bits) * level.tile_columns + (column >> tile_bits);
  }
  [[nodiscard]] static int cell_in_tile(int column, int row) {
    return (row % tile_side) * tile_side + column % tile_side;
  }
  [[nodiscard]] int head(const Level& level, int column, int row) const {
    const int tile = level.tiles[tile_of(level, column, row)];
    return tile < 0 ? none : heads_[tile + cell_in_tile(column, row)];
  }

  std::vector<Level> levels_;  ///< each with cells twice as wide as those of the one before
  std::vector<Cluster> clusters_;
  std::vector<int> heads_;  ///< by cell of the tiles in use: the cluster that came last
  int count_ = 0;
};

}  // namespace epura::drawing
