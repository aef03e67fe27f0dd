// SPDX-License-Identifier: Apache-2.0
// Closed outlines of a cut that do not determine where material is, because outlines around or inside them are open.
#pragma once

#include <span>
#include <vector>

#include "scene/cut_outline.hpp"

namespace epura::scene {

/// Segments of loose outlines as their bodies have them, and of closed ones by the body whose material they bound, both
/// sorted. By closed segment, whether it bounds nothing for certain: it is a hole of what is open around it, or what is
/// open inside it may be its hole. Senses of segments tell holes from nested solids. An open outline is taken as
/// closed by straight lines between the nearest of its ends.
std::vector<char> doubtful(std::span<const CutSegment> closed, std::span<const CutSegment> loose,
                           const CutPlaces& places, const PlaneFrame& frame);

/// The area to the left of segments less that to the right, in the lengths of the frame.
double directed_area(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame);

}  // namespace epura::scene
