// SPDX-License-Identifier: Apache-2.0
// A growing set of line pieces, searched by position.
//
// A piece is entered into the cells that it crosses, in a grid whose cells are about as large as the piece is long, so
// there are only a few of them, whatever the length. Grids take memory only where they contain pieces: their cells are
// allocated in square tiles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "search/line_cells.hpp"

namespace epura::drawing {

/// A set of undirected directions in 32 sectors, with one bit for each.
using Sectors = std::uint32_t;

/// Returns the sector of a direction.
int sector_of(const Vec2& direction);

/// Returns all sectors with directions that run along this one (along_cosine).
Sectors sectors_around(const Vec2& direction);

class InkCells {
 public:
  /// All lines must lie in the box; those of up to about `least` mm are in the finest grid.
  InkCells(const Vec2& min, const Vec2& max, double least);

  /// Parts are numbered in the order of addition. `sector` is that of the direction under which the part is to be
  /// found.
  void add(const Vec2& from, const Vec2& to, int sector = 0);
  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Returns the numbers of all parts within `margin` of a line, and of some others near it, ascending and without
  /// duplicates; only those in `wanted` if it is given.
  [[nodiscard]] std::vector<int> find(const Vec2& from, const Vec2& to, double margin,
                                      Sectors wanted = ~Sectors{}) const;
  /// The same numbers in any order, and some more than once.
  [[nodiscard]] std::vector<int> find_in_any_order(const Vec2& from, const Vec2& to, double margin,
                                                   Sectors wanted = ~Sectors{}) const;

 private:
  struct Level {
    search::CellGrid grid;
    int tile_columns;
    std::vector<int> tiles;  ///< index in `heads_` at which the cells of each tile begin, or none
    bool used = false;
  };
  /// Some parts of a cell, in half a cache line, and the cluster with the parts before them.
  struct Cluster {
    static constexpr int most = 5;
    int next;
    std::array<int, most> part;
    std::array<std::uint8_t, most> sector;
    std::uint8_t count;
  };
  static constexpr int none = -1;
  static constexpr int tile_bits = 4, tile_side = 1 << tile_bits;  ///< in cells

  // Most lines lie in a single cell of most grids.
  template <class Visit>
  static void visit_cells(const Level& level, const Vec2& from, const Vec2& to, double margin, const Visit& visit) {
    const search::CellGrid& grid = level.grid;
    const double slack = margin + grid.side.x * 0x1p-20;  // the slack that the search uses
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

  std::vector<Level> levels_;  ///< each has cells twice as wide as the one before
  std::vector<Cluster> clusters_;
  std::vector<int> heads_;  ///< by cell of the tiles in use: the latest cluster
  int count_ = 0;
};

}  // namespace epura::drawing
