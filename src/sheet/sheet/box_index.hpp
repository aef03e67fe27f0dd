// SPDX-License-Identifier: Apache-2.0
// Boxes indexed by position, for counting overlaps.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "sheet/boxes.hpp"

namespace epura::sheet {

/// Boxes by square cell of the paper. Equal boxes are stored once, with a count: dimensions between the same points
/// have the same few candidate positions again and again.
class BoxIndex {
 public:
  BoxIndex() = default;
  explicit BoxIndex(std::span<const TurnedBox> boxes) { add(boxes); }

  void add(std::span<const TurnedBox> boxes);
  /// Takes out boxes that were added.
  void remove(std::span<const TurnedBox> boxes);

  /// How many of them share more than their borders with the box; counted no further once they are more than `most`.
  [[nodiscard]] int overlaps(const TurnedBox& box, double most = HUGE_VAL) const;

  [[nodiscard]] bool meets(const TurnedBox& box) const { return overlaps(box, 0) > 0; }

  /// How many of them a line runs through that look parallel to it.
  [[nodiscard]] int along(const TurnedBox& line) const;

  /// How many lines run beside this one, in part, parallel to it and less than `apart` mm off; those less than `same`
  /// mm off are on it.
  struct LinesBeside {
    int on_it = 0, near = 0;
  };
  [[nodiscard]] LinesBeside beside(const TurnedBox& line, double same, double apart) const;

 private:
  using Cell = std::array<int, 2>;
  struct Entry {
    TurnedBox box;
    Vec2 min, max;  ///< of its bounding rectangle
    int count;      ///< in the cells if it is not 0
  };

  static Cell cell_at(const Vec2& place);
  static int number_of(const Cell& cell);
  /// Calls `visit(number of the cell)` for the cells that the box meets, until that returns false.
  template <class Visit>
  static void visit_cells_of(const TurnedBox& box, const Visit& visit);
  /// Calls `visit(entry)` once for each box whose rectangle meets that of this one, until that returns false.
  template <class Visit>
  void visit_near(const TurnedBox& box, const Visit& visit) const;

  std::vector<Entry> entries_;
  std::map<std::array<double, 6>, std::size_t> known_;
  std::unordered_map<int, std::vector<std::size_t>> cells_;  ///< by number_of
};

}  // namespace epura::sheet
