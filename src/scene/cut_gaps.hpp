// SPDX-License-Identifier: Apache-2.0
// Which outlines of a cut are closed, and which gaps in others are artefacts.
//
// Exporters leave cracks: they drop slivers, or give two faces different vertices along their common edge. Such a gap
// is no wider than the error of tessellation, and both of its ends belong to outlines many times as long.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "scene/cut_outline.hpp"

namespace epura::scene {

/// What explains a gap, in the lengths of a PlaneFrame.
struct GapLimits {
  double rounding;  ///< of the file
  /// Height of the part's surface over a facet; nothing where the surface is not known. Then the turns of the
  /// outline tell how coarse the tessellation is.
  std::function<std::optional<double>(int triangle)> sagitta;
};

struct Bridge {
  std::array<int, 2> vertex;  ///< lower first
  double width;               ///< in the lengths of the frame
};

/// Segments of one body, classified.
struct ToldApart {
  std::vector<CutSegment> closed;  ///< an even number meets in each vertex; bridges are among them
  std::vector<CutSegment> loose;   ///< belong to no closed outline
  std::vector<Bridge> bridges;
  std::vector<int> ends;  ///< vertices where loose ones end or branch, ascending
};

/// An end is bridged to the nearest other end where these two are alone and near enough for the limits. What then ends
/// somewhere is taken off; what branches after that bounds nothing for certain and is loose as a whole.
ToldApart tell_apart(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame,
                     const GapLimits& limits);

}  // namespace epura::scene
