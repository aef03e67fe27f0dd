// SPDX-License-Identifier: Apache-2.0
// Faces of parts that are seen edge-on: on paper, they are lines, and cylinders along their axes circles.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"
#include "view/paper_map.hpp"
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

/// Draws each cylinder seen along its axis as one circle. Two rims with different facets draw polygons that peep out
/// from behind each other, by as much as the circle rises over their chords; so do contours of facets between them. At
/// each angle, one of them stays: visible ones before hidden ones, rims before contours, and the longest first.
/// Remainders shorter than `least` mm are dropped. Throws OutOfTime.
LeftInk draw_circles_once(const visibility::ResolvedView& lines, const view::PaperMap& paper, double least,
                          std::vector<Piece> pieces, const Progress& progress = {});

}  // namespace epura::drawing
