// SPDX-License-Identifier: Apache-2.0
// Finds closed outlines of a cut that do not determine where material is, because outlines around or inside them are
// open.
#pragma once

#include <span>
#include <vector>

#include "cut/cut_outline.hpp"

namespace epura::cut {

/// `loose` are the segments of open outlines, `closed` those of closed ones, by the body whose material they bound;
/// both are sorted. Returns for each closed segment whether the area that it bounds is uncertain: its outline may be a
/// hole in an open outline around it, or an open outline inside it may be its hole. The orientation of segments
/// distinguishes holes from nested solids. An open outline is closed by straight lines between the nearest of its ends.
std::vector<char> doubtful(std::span<const CutSegment> closed, std::span<const CutSegment> loose,
                           const CutPlaces& places, const PlaneFrame& frame);

/// Returns the area to the left of segments minus that to their right, in the units of the frame.
double directed_area(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame);

}  // namespace epura::cut
