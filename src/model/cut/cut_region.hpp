// SPDX-License-Identifier: Apache-2.0
// Restricts the outlines of a cut to one region of a cutting surface.
#pragma once

#include <span>
#include <vector>

#include "cut/cut_outline.hpp"
#include "cut/cutting_surface.hpp"

namespace epura::cut {

/// Outlines of one body's cut in a region.
struct RegionOutlines {
  std::vector<CutSegment> closed;  ///< sorted; parts along borders included
  std::vector<CutSegment> drawn;   ///< sorted; those that are not along borders
  std::vector<int> ends;           ///< vertices on borders that have no partner: the outlines are not closed
};

/// A CutMesh that gets vertices where outlines cross borders.
struct GrowingCut {
  std::span<const Vec3> file;
  CutMesh& cut;

  [[nodiscard]] CutPlaces places() const { return {file, cut.points}; }
};

/// The outlines are closed; along each border, an even number of their ends is joined in pairs.
RegionOutlines clip_outlines(std::span<const CutSegment> segments, const std::vector<CutBorder>& borders,
                             GrowingCut cut, double slack);

}  // namespace epura::cut
