// SPDX-License-Identifier: Apache-2.0
// Judges the ink that the user gets, where it is drawn.
//
// Stages before this one move lines onto surfaces, join and drop them. This judge asks of every place on the finished
// lines for a reason within the error that the run states: an edge of the part, a contour, a crossing, a border. It
// looks for one among the triangles there, and asks the faces of the part what they are worth (PartEyes); where it
// finds none, rays at the surfaces have the last word (surface_sight.hpp). Where triangles require a line and the
// drawing has none within that error, rays must confirm that what is seen changes there.
#pragma once

#include <span>

#include "base/progress.hpp"
#include "report/verification.hpp"
#include "verify/cover.hpp"
#include "verify/line_scan.hpp"
#include "verify/outline.hpp"

namespace epura::verify {

struct InkOptions {
  OutlineOptions outline;
  double error;         ///< mm, how far lines may be from their reasons, as the run states it
  bool creases = true;  ///< whether all creases are drawn, however short
};

/// `needs`: positions that require a line, from lines across the page. The drawing of `input` must be the one that the
/// user gets. Throws OutOfTime.
report::InkCheck judge_ink(const VerifyInput& input, const Tolerance& tolerance, const InkOptions& options,
                           std::span<const AskedLine> needs);

}  // namespace epura::verify
