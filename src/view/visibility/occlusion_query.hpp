// SPDX-License-Identifier: Apache-2.0
// The parts of one edge that triangles hide.
#pragma once

#include <array>
#include <limits>
#include <utility>

#include "visibility/hiding_rule.hpp"
#include "visibility/occluders.hpp"
#include "visibility/spans.hpp"
#include "visibility/visibility.hpp"

namespace epura::visibility {

/// Each triangle's hidden part is computed for the whole edge, so the union does not depend on cells or order.
class OcclusionQuery {
 public:
  /// The search of a tree is abandoned after `max_tries` tests.
  OcclusionQuery(const view::ProjectedScene& view, const OccluderGrid& occluders, const PageEdge& line,
                 const OwnTriangles& own, int max_tries = std::numeric_limits<int>::max());

  /// Everything behind the cover of the cell is hidden. Otherwise, candidates are tested until the segment is hidden or
  /// the remaining candidates lie behind it.
  void hide(const CellSegment& stretch);

  /// Returns what has been hidden so far, without slivers that are due to rounding.
  [[nodiscard]] Spans spans() &&;

  [[nodiscard]] int tries() const { return tries_; }

 private:
  // Whether a triangle hides something and was not among the last ones tested.
  bool hide_by(int triangle) {
    if (std::exchange(tried_[triangle % tried_.size()], triangle) == triangle) return false;
    const view::ViewTriangle& tried = view_.triangles[triangle];
    ++tries_;
    const auto part = hidden_part(view_, line_, tried);
    if (!part || own_.contain(tried.source)) return false;  // last: next to slivers, own triangles are many
    add_span(spans_, *part);
    return true;
  }

  // Whether a triangle of the pile hides something.
  bool hide_by(const Pile& pile);
  bool hide_by_exact(const Pile& pile);
  void hide_by_tree(const CellSegment& stretch);

  const view::ProjectedScene& view_;
  const OccluderGrid& occluders_;
  PageEdge line_;
  OwnTriangles own_;
  std::array<int, 64> tried_;  ///< the last triangles tested, by the last bits of their numbers
  Spans spans_;
  int max_tries_, tries_ = 0;
};

}  // namespace epura::visibility
