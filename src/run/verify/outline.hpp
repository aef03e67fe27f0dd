// SPDX-License-Identifier: Apache-2.0
// Tests the choice of lines, in addition to their visibility (verify.hpp).
//
// Random lines cross the page. The scene is cut along each of them, and the visible part of the section is found. Where
// its depth jumps, or where two visible faces meet in a fold that requires an edge, there must be visible ink; and
// where visible ink crosses the line, there must be such a position. All of this is derived from triangles alone;
// visible wires need ink, too.
//
// A fault counts if it extends along its line for more than a few times the precision of positions on the page.
// Additional short lines across it determine its length.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "projection/projection.hpp"
#include "report/verification.hpp"
#include "verify/cover.hpp"
#include "verify/line_scan.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

struct OutlineOptions {
  edges::EdgeOptions edges;
  int samples;                                 ///< approximate number of positions with ink to be tested
  bool complete = true;                        ///< whether nothing was omitted for lack of time
  std::optional<projection::Window> window{};  ///< of the page, mm, outside which nothing is drawn
  Progress progress{};
};

struct OutlineFindings {
  report::OutlineCheck check;
  std::vector<AskedLine> needs;  ///< positions that require a line, and where depth jumps
};

/// Throws OutOfTime.
OutlineFindings scan_outline(const VerifyInput& input, const Tolerance& tolerance, const OutlineOptions& options);

}  // namespace epura::verify
