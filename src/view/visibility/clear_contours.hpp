// SPDX-License-Identifier: Apache-2.0
// Contours that only facets of their own face hide: they are no smooth surface.
#pragma once

#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"

namespace epura::visibility {

/// Sets FeatureEdges::clear_contours: those with FeatureEdge::clear of which facets around them would hide a part.
/// Throws OutOfTime.
void find_clear_contours(const world::World& world, const view::ProjectedScene& view, edges::FeatureEdges& drawn,
                         const Progress& progress = {});

}  // namespace epura::visibility
