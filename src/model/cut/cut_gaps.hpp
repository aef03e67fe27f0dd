// SPDX-License-Identifier: Apache-2.0
// Determines which outlines of a cut are closed, and which gaps in the others are artefacts.
//
// Exporters leave cracks: they drop slivers, or give two faces different vertices along their common edge. Such a gap
// is no wider than the tessellation error, and both of its ends belong to outlines many times as long.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "cut/cut_outline.hpp"

namespace epura::cut {

/// The possible causes of a gap, in the units of a PlaneFrame.
struct GapLimits {
  double rounding;  ///< of the file
  /// Height of the part's surface above a facet; nothing if the surface is unknown. The fineness of tessellation is
  /// then estimated from the turns of the outline.
  std::function<std::optional<double>(int triangle)> sagitta;
};

struct Bridge {
  std::array<int, 2> vertex;  ///< lower first
  double width;               ///< in the units of the frame
};

/// Segments of one body, classified.
struct ToldApart {
  std::vector<CutSegment> closed;  ///< an even number meets in each vertex; includes bridges
  std::vector<CutSegment> loose;   ///< not part of a closed outline
  std::vector<Bridge> bridges;
  std::vector<int> ends;  ///< vertices at which loose segments end or branch, ascending
};

/// Bridges each end to the nearest other end if no third end is near and the gap is within the limits. Segments that
/// still lead to an end are then removed; outlines that still branch bound no certain area, and all of their segments
/// are loose.
ToldApart tell_apart(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame,
                     const GapLimits& limits);

}  // namespace epura::cut
