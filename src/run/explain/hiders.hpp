// SPDX-License-Identifier: Apache-2.0
// Finds the faces that hide an edge by applying the hiding rule to all triangles that meet the edge's box on the page,
// including those behind other occluders.
#pragma once

#include <vector>

#include "explain/subject.hpp"
#include "search/bounds_tree.hpp"
#include "visibility/spans.hpp"

namespace epura::explain {

/// A face that hides parts of an edge.
struct Occlusion {
  FaceName face;
  visibility::Spans parts;  ///< page parameters of the edge
  double ahead;  ///< distance in front, along the line of sight: the minimum over the middles of its triangles' parts
};

/// The triangles of a view by their boxes on the page, in mm.
class TriangleBoxes {
 public:
  using Box = search::Bounds<2>;

  explicit TriangleBoxes(const view::ProjectedScene& view);

  /// Calls `visit(triangle)` for all triangles of the view whose boxes meet `box`, in order.
  template <class Visit>
  void meeting(const Box& box, Visit visit) const {
    tree_.visit(box, [&](std::size_t triangle) {
      if (search::meet<2>(boxes_[triangle], box)) visit(static_cast<int>(triangle));
      return true;
    });
  }

 private:
  std::vector<Box> boxes_;
  search::BoundsTree<2> tree_;
};

/// Returns the faces that hide parts of the e-th drawn edge, nearest to it first.
std::vector<Occlusion> find_hiders(const ExplainInput& drawn_view, const TriangleBoxes& boxes, std::size_t e);

}  // namespace epura::explain
