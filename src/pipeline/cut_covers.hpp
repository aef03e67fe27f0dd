// SPDX-License-Identifier: Apache-2.0
// Lines of a section that an inserted body covers, though both are in the plane.
#pragma once

#include <array>
#include <vector>

#include "edges/find_edges.hpp"
#include "pipeline/sections.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace epura::pipeline {

/// Two bodies of a cut world, each by its model and number: the larger one, and the one that covers it.
using OverlappingBodies = std::array<std::array<int, 2>, 2>;

/// Adds the parts of outlines and thread lines inside cut faces of other bodies, of which a pair overlaps, to what is
/// hidden. Returns these pairs. Nothing in central projections.
std::vector<OverlappingBodies> hide_in_overlaps(const CutSection& section, view::ProjectedScene& view,
                                                const view::PaperMap& paper, const edges::FeatureEdges& drawn,
                                                visibility::HiddenSpans& hidden);

/// Warns of overlaps: a section of sound models has none.
void warn_about(const Messages& messages, const CutSection& section, std::span<const OverlappingBodies> overlaps);

}  // namespace epura::pipeline
