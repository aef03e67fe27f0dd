// SPDX-License-Identifier: Apache-2.0
// Finds the faces that hide an edge by applying the hiding rule to all triangles that meet the edge's box on the page,
// including those behind other occluders.
#pragma once

#include <vector>

#include "explain/subject.hpp"
#include "visibility/spans.hpp"

namespace epura::explain {

/// A face that hides parts of an edge.
struct Occlusion {
  FaceName face;
  visibility::Spans parts;  ///< page parameters of the edge
  double ahead;  ///< distance in front, along the line of sight: the minimum over the middles of its triangles' parts
};

/// Finds the triangles of a view that meet a box of the page: a tree of boxes over runs of triangles, in their order.
class TriangleBoxes {
 public:
  explicit TriangleBoxes(const view::ProjectedScene& view);

  /// Calls `visit(triangle)` for all triangles of the view whose boxes meet `box`, in order.
  template <class Visit>
  void meeting(const projection::Window& box, Visit visit) const {
    for (std::size_t i = 0; i < levels_.back().size(); ++i) search(levels_.size() - 1, i, box, visit);
  }

 private:
  static constexpr std::size_t run = 16;

  static bool meet(const projection::Window& a, const projection::Window& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
  }

  template <class Visit>
  void search(std::size_t level, std::size_t number, const projection::Window& box, Visit& visit) const {
    if (!meet(levels_[level][number], box)) return;
    if (level == 0) return visit(static_cast<int>(number));
    const std::size_t end = std::min((number + 1) * run, levels_[level - 1].size());
    for (std::size_t i = number * run; i < end; ++i) search(level - 1, i, box, visit);
  }

  /// Boxes by level: of triangles, of runs of triangles, of runs of runs.
  std::vector<std::vector<projection::Window>> levels_;
};

/// Returns the faces that hide parts of the e-th drawn edge, nearest to it first.
std::vector<Occlusion> find_hiders(const ExplainInput& drawn_view, const TriangleBoxes& boxes, std::size_t e);

}  // namespace epura::explain
