// SPDX-License-Identifier: Apache-2.0
// How well a drawing represents a part: its ink compared with the part's exact lines, on the same page, mm.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::bench {

struct PageLine {
  Vec2 from, to;
};

using PageLines = std::vector<PageLine>;

/// Lines of the exact geometry. A drawing may show or omit edges between faces that continue each other smoothly: such
/// smooth edges do not count as missing, and ink beside them does not count as wrong.
struct ExactLines {
  PageLines visible, hidden;  ///< sharp edges and outlines
  PageLines smooth_visible, smooth_hidden;
};

struct Ink {
  PageLines visible, hidden;
};

struct Score {
  double recall;            ///< fraction of the visible exact lines with visible ink beside them
  double precision;         ///< fraction of the visible ink beside visible exact lines
  double recall_hidden;     ///< fraction of the hidden exact lines with ink beside them
  double precision_hidden;  ///< fraction of the hidden ink beside exact lines
  double exact;             ///< mm of visible exact lines
  double ink;               ///< mm of visible ink
  double loose_ends;  ///< of visible ink, without contact to other visible ink. A few are right: outlines end in cusps
};

/// Beside means within 0.4 mm, slightly less than the width of a wide line. If there are no lines of a kind, a fraction
/// is 1.
Score score_of(const Ink& ink, const ExactLines& exact);

}  // namespace epura::bench
