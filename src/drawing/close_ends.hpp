// SPDX-License-Identifier: Apache-2.0
// Links ends of lines that met removed ink to the ink that is drawn instead.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/kept_ink.hpp"

namespace epura::drawing {

/// mm
struct ClosingLimits {
  double touching;  ///< lines so near meet
  double along;     ///< so far lines are prolonged or cut off
};

/// `left` are the parts that are kept, ascending and as long as they continue. An end on taken ink and on no line that
/// stays is joined to the one that is drawn for that ink: along its own line, where they meet within a short way, and
/// otherwise across. Lines that go too far are cut off. Links belong to the point of the edge that they begin at. Lines
/// of which nothing is left are left out. Hidden ink is none for visible lines. Throws OutOfTime.
std::vector<Piece> close_ends(const InkParts& kept, const TakenInk& taken, const std::vector<InkPart>& left,
                              const ClosingLimits& limits, const Progress& progress);

}  // namespace epura::drawing
