// SPDX-License-Identifier: Apache-2.0
// A test of the choice of lines, in addition to that of their visibility (verify.hpp).
//
// Random lines cross the page. Over each of them the scene is cut, and the visible part of the cut is found. Where its
// depth jumps, or where two visible faces meet in a fold that requires an edge, there must be visible ink; and where
// visible ink crosses the line, there must be such a position. All of it is found from triangles alone; visible wires
// need ink, too.
//
// A fault counts if it extends along its line for more than a few times the precision of positions on the page. Its
// length is found by additional, short lines across it.
#pragma once

#include <optional>

#include "base/progress.hpp"
#include "projection/projection.hpp"
#include "report/verification.hpp"
#include "verify/cover.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

struct OutlineOptions {
  edges::EdgeOptions edges;
  int samples;                                 ///< about as many places with ink are met
  bool complete = true;                        ///< nothing was omitted for lack of time
  std::optional<projection::Window> window{};  ///< of the page, mm, outside which nothing is drawn
  Progress progress{};
};

/// Throws OutOfTime.
report::OutlineCheck verify_outline(const VerifyInput& input, const Tolerance& tolerance,
                                    const OutlineOptions& options);

}  // namespace epura::verify
