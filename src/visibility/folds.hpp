// SPDX-License-Identifier: Apache-2.0
// Contours of facets where their surface has none, or hides it: those of facets that a tessellation turned over, and
// those that go on beyond a cusp.
#pragma once

#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace epura::visibility {

/// Adds to `hidden` what lies beyond cusps (FeatureEdge::hollow), and where contours of facets that are turned over
/// (FeatureEdge::by_chance) are no outlines: on the other side of them, their face
/// goes on no farther behind than their facets are deep. To find out, lines next to them at that depth are tested like
/// edges against such faces. Throws OutOfTime.
void hide_folds(const scene::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                HiddenSpans& hidden, const Progress& progress = {});

}  // namespace epura::visibility
