// SPDX-License-Identifier: Apache-2.0
// Finds out whether connected triangles hide a whole cell together although none of them covers it alone.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "view/projected_scene.hpp"
#include "visibility/hiding_rule.hpp"

namespace epura::visibility {

/// A cell of the page, already widened by the amount that rounding may move things.
struct CellBox {
  Vec2 middle, half;
};

/// The plane of a triangle, used to cover cells of one size.
class CoverPlane {
 public:
  /// `half` is half the width and height of a cell, widened.
  CoverPlane(const view::ProjectedScene& view, const view::ViewTriangle& triangle, const Vec2& half);

  /// Where the triangle covers the cell around `middle`, it hides everything with less depth than this, which lies
  /// behind every point of the plane in the cell by more than contact and rounding. -infinity for a triangle that is a
  /// line on the page.
  [[nodiscard]] double depth(const Vec2& middle) const { return depth_ + glm::dot(slope_, middle - corner_); }

 private:
  Vec2 corner_, slope_{0, 0};
  double depth_ = -HUGE_VAL;
};

/// Grows connected sheets from triangles that are added one by one. A sheet is complete when every side that may reach
/// into the cell has triangles on both sides: then all places of the cell are covered by equally many triangles, hence
/// by at least one.
class OccluderPatch {
 public:
  OccluderPatch(const view::ProjectedScene& view, const CellBox& cell) : view_(view), cell_(cell) {}

  /// Whether adding this triangle, which must have an area on the page grid, has completed a sheet.
  bool add(const view::ViewTriangle& triangle);

  /// The completed sheet hides everything in the cell with less depth than this.
  [[nodiscard]] double depth() const { return depth_; }

 private:
  struct Sheet {
    int parent;    ///< another sheet that this one was merged into, or itself
    int open = 0;  ///< number of sides that lack a triangle on their other side
    double depth;
  };
  struct OpenSide {
    int sheet;
    bool left;  ///< whether the triangle lies to the left, seen from the vertex with the lower number
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
