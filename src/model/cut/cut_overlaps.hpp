// SPDX-License-Identifier: Apache-2.0
// Cut faces of bodies that overlap, such as a screw drawn with its outer diameter in the core of a thread.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"
#include "cut/cut_world.hpp"
#include "cut/model_cut.hpp"
#include "mesh/even_odd.hpp"

namespace epura::cut {

/// An area, and its centroid.
struct FlatArea {
  double size = 0;
  Vec2 middle{0.0};
};

FlatArea area_of(mesh::Outlines outlines);

/// What two areas have in common, by even-odd areas alone: of outlines that only touch, nearly nothing.
FlatArea common_area(const mesh::Outlines& a, const mesh::Outlines& b);

struct OutlinesOutside {
  mesh::Outlines outlines;
  std::vector<std::vector<int>> divided;  ///< for each segment of the first area: its places, from end to end
};

/// The part of an area outside another one. Its places begin with those of `under`, used or not, which are followed by
/// corners of `over` inside and by crossings. Parts of outlines within 1e-9 of the whole size of each other coincide.
/// Nothing if rounding leaves it open.
std::optional<OutlinesOutside> part_outside(const mesh::Outlines& under, const mesh::Outlines& over);

/// Where cut faces of bodies overlap, the inner one covers the other: the one in which the middle of what they have in
/// common lies, as a screw is between both sides of its hole; otherwise the one with less volume. The other is left as
/// it is if rounding would leave its outline open. Throws OutOfTime.
std::vector<OverlappingBodies> settle_overlaps(std::vector<ModelCut>& cuts, const Progress& progress);

}  // namespace epura::cut
