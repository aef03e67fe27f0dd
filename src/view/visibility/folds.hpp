// SPDX-License-Identifier: Apache-2.0
// Where facets and their surface disagree on its own contours: facets have contours where the surface has none, since a
// tessellation turned them over, or hides it, beyond a cusp; and they hide contours that are clear of the surface.
#pragma once

#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace epura::visibility {

/// Sets FeatureEdges::clear_contours: those with FeatureEdge::clear of which facets around them would hide a part,
/// since they are no smooth surface. Throws OutOfTime.
void find_clear_contours(const world::World& world, const view::ProjectedScene& view, edges::FeatureEdges& drawn,
                         const Progress& progress = {});

/// Adds to `hidden` where contours of facets (FeatureEdge::by_chance, hollow) are no outlines: on the other side of
/// them, their face goes on no farther behind than their facets are deep, or twice that beyond a cusp. To find out,
/// lines next to them at that depth are tested like edges against such faces. Lines that are drawn on a torus, not on
/// its facets, are tested against it where they are drawn. What is no outline of those that are there by chance is a
/// fold, visible or not (HiddenSpans::folds). Throws OutOfTime.
void hide_folds(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
                HiddenSpans& hidden, const Progress& progress = {});

}  // namespace epura::visibility
