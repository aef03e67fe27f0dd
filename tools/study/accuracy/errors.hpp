// SPDX-License-Identifier: Apache-2.0
// How wrong a classification of drawn edges is, measured against the right one.
//
// A place is misclassified where one says visible and the other hidden. Lengths are mm of paper.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "visibility/spans.hpp"

namespace epura::study {

/// A drawn edge on paper, not a mere point, with its hidden spans: as some method found them, and as they should be.
struct JudgedEdge {
  Vec2 from, to;
  visibility::Spans shown, right;
};

struct Errors {
  double longest = 0;     ///< E_max: the longest misclassified span of an edge
  double sum = 0;         ///< E_sum: of all such spans
  double ink = 0;         ///< E_ink: Hausdorff distance of the visible ink, both ways; infinite if only one has any
  double end_point = 0;   ///< farthest shift of an end of a visible span that meets one shown, and that no other
  long long missed = 0;   ///< visible spans of which nothing is shown
  long long phantom = 0;  ///< spans shown visible of which nothing is
  long long cracks = 0;   ///< spans shown hidden within a visible one: the line is broken
  long long edges = 0;    ///< with a misclassified span
  long long judged = 0;   ///< edges
};

/// Spans that are not longer than `min` mm are not counted; their lengths are measured all the same.
Errors measure_errors(const std::vector<JudgedEdge>& edges, double min = 0);

}  // namespace epura::study
