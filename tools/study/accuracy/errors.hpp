// SPDX-License-Identifier: Apache-2.0
// Errors of a classification of drawn edges, measured against the correct one.
//
// A point is misclassified if one classification says visible and the other hidden. Lengths are in mm on paper.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "visibility/spans.hpp"

namespace epura::study {

/// A drawn edge on paper, longer than a point, with its hidden spans as found by some method and the correct ones.
struct JudgedEdge {
  Vec2 from, to;
  visibility::Spans shown, right;
};

struct Errors {
  double longest = 0;     ///< E_max: the longest misclassified span of an edge
  double sum = 0;         ///< E_sum: total length of all such spans
  double ink = 0;         ///< E_ink: Hausdorff distance of the visible ink, both ways; infinite if only one has any
  double end_point = 0;   ///< largest shift of an end of a visible span that overlaps a shown one, and no other
  long long missed = 0;   ///< visible spans of which nothing is shown
  long long phantom = 0;  ///< spans shown visible of which nothing is visible
  long long cracks = 0;   ///< spans shown hidden inside a visible one: the line is broken
  long long edges = 0;    ///< edges with a misclassified span
  long long judged = 0;   ///< edges tested
};

/// Spans of at most `min` mm are not counted, but their lengths are measured.
Errors measure_errors(const std::vector<JudgedEdge>& edges, double min = 0);

}  // namespace epura::study
