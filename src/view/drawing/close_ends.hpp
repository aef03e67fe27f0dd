// SPDX-License-Identifier: Apache-2.0
// Connects ends of lines that met removed ink to the ink that is drawn instead.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/kept_ink.hpp"

namespace epura::drawing {

/// In mm.
struct ClosingLimits {
  double touching;  ///< lines this close together meet
  double along;     ///< by how much lines are extended or cut off, at most
};

/// `left` are the parts that are kept, ascending, continuous parts in one. An end that lies on taken ink and on no line
/// that stays is connected to the line that is drawn for that ink: along its own line where the two meet within a short
/// distance, otherwise across. Lines that reach too far are cut off. A link belongs to the point of the edge at which
/// it begins. Lines of which nothing remains are left out. For visible lines, hidden ink does not count. Throws
/// OutOfTime.
std::vector<Piece> close_ends(const InkParts& kept, const TakenInk& taken, const std::vector<InkPart>& left,
                              const ClosingLimits& limits, const Progress& progress);

}  // namespace epura::drawing
