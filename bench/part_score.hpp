// SPDX-License-Identifier: Apache-2.0
// How far a drawing is a drawing of the part: its ink beside the part's exact lines, on the same page, in millimetres.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::bench {

struct PageLine {
  Vec2 from, to;
};

using PageLines = std::vector<PageLine>;

/// What exact geometry shows. Whether an edge between faces that go on from each other is drawn is the drawing's own
/// affair: such smooth edges are not missed, and nothing that lies on them is wrong.
struct ExactLines {
  PageLines visible, hidden;  ///< sharp edges and outlines
  PageLines smooth_visible, smooth_hidden;
};

struct Ink {
  PageLines visible, hidden;
};

struct Score {
  double recall;            ///< share of the visible exact lines beside which there is visible ink
  double precision;         ///< share of the visible ink that lies beside visible exact lines
  double recall_hidden;     ///< share of the hidden exact lines beside which there is ink
  double precision_hidden;  ///< share of the hidden ink that lies beside exact lines
  double exact;             ///< mm of visible exact lines
  double ink;               ///< mm of visible ink
  double loose_ends;  ///< of visible ink, which touch no other visible ink. A few are right: outlines end in cusps
};

/// Beside means within 0.4 mm, somewhat less than the width of a wide line. Where there is nothing to find, a share
/// is 1.
Score score_of(const Ink& ink, const ExactLines& exact);

}  // namespace epura::bench
