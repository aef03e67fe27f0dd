// SPDX-License-Identifier: Apache-2.0
// Parts of lines, found by where they lie, while more and more of them come.
//
// A part stands in the cells that it passes through, of a grid whose cells are about as large as the part is long, so
// that it stands in few of them whatever its length. Grids are only as large as what stands in them: cells are hashed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "search/line_cells.hpp"

namespace epura::drawing {

class InkCells {
 public:
  /// All lines lie in the box; those up to about `least` mm stand in the finest grid.
  InkCells(const Vec2& min, const Vec2& max, double least);

  /// The part's number is that of the parts that came before it.
  void add(const Vec2& from, const Vec2& to);
  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Calls `visit(part)` for all parts within `margin` of a line, for some others near it, and perhaps for some more
  /// than once, until it returns false. The order is always the same.
  template <class Visit>
  void visit(const Vec2& from, const Vec2& to, double margin, const Visit& visit) const {
    bool wanted = true;
    for (std::size_t level = 0; level < levels_.size() && wanted; ++level) {
      if (!levels_[level].used) continue;
      search::visit_cells(levels_[level].grid, from, to, margin, [&](int cell, double, double) {
        for (int i = wanted ? head(key_of(level, cell)) : -1; i >= 0 && wanted; i = links_[i].next)
          wanted = visit(links_[i].part);
      });
    }
  }

 private:
  struct Level {
    search::CellGrid grid;
    bool used = false;
  };
  struct Link {
    int part, next;
  };
  struct Slot {
    std::uint64_t key = 0;
    int head = -1;
  };

  static std::uint64_t key_of(std::size_t level, int cell) {
    return (static_cast<std::uint64_t>(level) << 32) | static_cast<std::uint32_t>(cell);
  }
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const;
  [[nodiscard]] int head(std::uint64_t key) const { return slots_[slot_of(key)].head; }
  void grow();

  std::vector<Level> levels_;  ///< each with cells twice as wide as those of the one before
  std::vector<Link> links_;
  std::vector<Slot> slots_ =
      std::vector<Slot>(64);  ///< by the hash of the key, or the next free one; a power of two of them
  std::size_t taken_ = 0;
  int count_ = 0;
};

}  // namespace epura::drawing
