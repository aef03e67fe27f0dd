// SPDX-License-Identifier: Apache-2.0
// Faces of parts that are seen edge-on: on paper, they are lines.
#pragma once

#include <vector>

#include "visibility/visibility.hpp"

namespace epura::drawing {

class FacesEdgeOn {
 public:
  /// In a parallel view; in a perspective there are none.
  explicit FacesEdgeOn(const visibility::ResolvedView& lines);

  /// Whether an edge is a contour inside such a face. Where the facets at the two rims of a face differ, as around a
  /// bore seen along its axis, its contour climbs in steps from one rim to the other, which say nothing about the part.
  [[nodiscard]] bool has_step(const edges::FeatureEdge& edge) const;

 private:
  const world::World& world_;
  std::vector<std::vector<char>> edge_on_;  ///< of each model's faces; empty without recognised ones
};

}  // namespace epura::drawing
