// SPDX-License-Identifier: Apache-2.0
// Views in rows and columns, placed as a unit at a scale still to be chosen.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// A positioned view: page = scale * plane + shift, mm.
struct ViewSpot {
  std::size_t view;
  double scale;
  Vec2 shift;
  Rectangle box;  ///< on the page, including the space kept free around the ink
};

inline ViewSpot moved(const ViewSpot& spot, const Vec2& by) {
  return {spot.view, spot.scale, spot.shift + by, {spot.box.min + by, spot.box.max + by}};
}

/// A view in a table. Views of a column have their anchors above each other, views of a row side by side.
struct ViewCell {
  std::size_t view;
  int column, row;                ///< row 0 is the top
  Vec2 anchor;                    ///< point of the projection plane
  Vec2 min, max;                  ///< of the ink relative to the anchor, to be scaled
  Vec2 before, after;             ///< mm on paper to the left and below, to the right and above; not scaled
  std::optional<double> scale{};  ///< the view's own; `before` and `after` then include its ink
};

class ViewTable {
 public:
  /// `gap` mm of paper between the boxes of columns and of rows. Columns and rows without a view take no room.
  ViewTable(std::vector<ViewCell> cells, double gap);

  /// Size of the whole table, mm.
  [[nodiscard]] Vec2 size(double scale) const;

  /// The largest scale at which it fits into `room`: infinite if all ink is a point, 0 if gaps and margins alone are
  /// too large.
  [[nodiscard]] double largest_scale(const Vec2& room) const;

  /// The views in the order of the cells, with the table's lower left corner at `corner`.
  [[nodiscard]] std::vector<ViewSpot> spots(double scale, const Vec2& corner) const;

 private:
  // A column or row: its scaled and its fixed parts.
  struct Band {
    bool used = false;
    double min = 0, max = 0;
    double before = 0, after = 0;
  };
  struct Lines {
    double scaled = 0, fixed = 0;  // the whole length is scale * scaled + fixed
    std::vector<Band> bands;
  };
  static void extend(Lines& lines, int band, const ViewCell& cell, int axis);
  static void sum_up(Lines& lines, double gap);
  [[nodiscard]] std::vector<double> anchors(const Lines& lines, double scale) const;

  std::vector<ViewCell> cells_;
  double gap_;
  Lines columns_, rows_;  // rows from below
};

}  // namespace epura::sheet
