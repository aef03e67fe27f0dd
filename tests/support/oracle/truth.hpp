// SPDX-License-Identifier: Apache-2.0
// The truth about drawn edges, in rational numbers.
//
// Every edge is held against every triangle that its box meets on the page. Corners are mapped to the page from the
// doubles of the model and of the projection without rounding, (3.10) and (3.20) of seed 003 with a depth that keeps
// planes flat, and the part of the edge that a triangle hides is a rational interval. Nothing of it is shared with the
// methods under test but the list of edges and the unit of the page: triangles that a view has lost are found missing.
//
// Two answers are kept: what stays hidden when the triangles shrink by 1e-9 of the drawing and come nearer to the edge
// by twice the contact tolerance, and what may be hidden when they grow as much. Between the two the input does not
// tell. A side that two triangles share, one on either side of it, is not a border and does not shrink.
#pragma once

#include <array>
#include <vector>

#include "verify/verify_input.hpp"
#include "visibility/spans.hpp"

namespace epura {

struct EdgeTruth {
  int edge;                   ///< of the drawn edges
  visibility::Spans surely;   ///< hidden
  visibility::Spans perhaps;  ///< hidden, or not to be told; contains `surely`
};

/// Which edges are judged: those that come first in a random order (a fixed seed), until so many pairs of edge and
/// triangle have been looked at exactly.
struct TruthEffort {
  double pairs = 2e5;
};

/// In the order of the edges.
std::vector<EdgeTruth> find_truth(const verify::VerifyInput& input, const view::ProjectedScene& view,
                                  const TruthEffort& effort);

/// A triangle and a point of an edge, exactly as their places on the page say.
struct PointTruth {
  double inside;     ///< how far the point lies from the nearest side; negative outside
  double ahead;      ///< how far the plane of the triangle lies before it
  double steepness;  ///< of that plane, 1 square to the view
};

/// Of the point at page parameter `s` of the edge.
PointTruth truth_of_point(const std::array<view::PageVertex, 3>& triangle, const std::array<view::PageVertex, 2>& edge,
                          double s);

/// The right classification that is nearest to the one shown: where the truth leaves the choice, as it is shown.
visibility::Spans nearest_right(const visibility::Spans& shown, const EdgeTruth& truth);

}  // namespace epura
