// SPDX-License-Identifier: Apache-2.0
// Whether triangles with common sides hide a whole cell together, although none of them covers it alone.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/hiding_rule.hpp"

namespace epura::visibility {

/// A cell of the page, already widened by what rounding may move.
struct CellBox {
  Vec2 middle, half;
};

/// A triangle as the cover of cells of one size.
class CoverPlane {
 public:
  /// `half` of the width and height of a cell, widened.
  CoverPlane(const view::ProjectedScene& view, const view::ViewTriangle& triangle, const Vec2& half);

  /// What lies deeper in the cell around a place is hidden wherever the triangle covers it: deeper than any place of
  /// its plane there by more than contact and rounding. -infinity for a triangle that is a line on the page.
  [[nodiscard]] double depth(const Vec2& middle) const { return depth_ + glm::dot(slope_, middle - corner_); }

 private:
  Vec2 corner_, slope_{0, 0};
  double depth_ = -HUGE_VAL;
};

/// Grows connected sheets from triangles, added one by one. A sheet is whole when every side that may reach into the
/// cell has triangles on both sides: as many triangles cover one place of the cell as another, and so at least one.
class OccluderPatch {
 public:
  OccluderPatch(const view::ProjectedScene& view, const CellBox& cell) : view_(view), cell_(cell) {}

  /// Whether this triangle, which has an area on the page grid, has made a sheet whole.
  bool add(const view::ViewTriangle& triangle);

  /// What lies deeper in the cell is hidden by the sheet that was made whole.
  [[nodiscard]] double depth() const { return depth_; }

 private:
  struct Sheet {
    int parent;    ///< another sheet that this one has become part of, or itself
    int open = 0;  ///< sides that need a triangle on their other side
    double depth;
  };
  struct OpenSide {
    int sheet;
    bool left;  ///< on which side of it, seen from its vertex with the lesser number, the triangle lies
  };

  [[nodiscard]] bool reaches_in(int u, int v) const;
  [[nodiscard]] bool holds_middle(const view::ViewTriangle& triangle) const;
  int root(int sheet);
  void close(int sheet, const view::ViewTriangle& triangle, int side, bool turns_left);

  const view::ProjectedScene& view_;
  CellBox cell_;
  std::vector<Sheet> sheets_;
  std::unordered_map<std::uint64_t, OpenSide> open_;
  double depth_ = -HUGE_VAL;
};

}  // namespace epura::visibility
