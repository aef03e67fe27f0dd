// SPDX-License-Identifier: Apache-2.0
// Selects the mesh edges that are drawn: contours, boundaries, creases and others.
#pragma once

#include <optional>
#include <vector>

#include "edges/edge_kind.hpp"
#include "edges/find_edges.hpp"
#include "edges/slivers.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

/// Returns for every edge of a model the reason why it is drawn, or nothing.
///
/// The orientation of faces is not used: an edge is a contour if its two triangles lie on the same side of it on the
/// page, or if one of them is seen edge-on. Hence inside-out, one-sided and inconsistently oriented surfaces are drawn
/// alike. Outlines of cuts are always drawn. Throws OutOfTime.
std::vector<std::optional<EdgeKind>> feature_edges(const world::World& world, const view::ProjectedScene& view,
                                                   int model, const EdgeOptions& options,
                                                   const Progress& progress = {});

/// The same, if the slivers of the model in the view are already known.
std::vector<std::optional<EdgeKind>> feature_edges(const view::ProjectedScene& view, const EdgeOptions& options,
                                                   const EdgeSurroundings& around, const Slivers& slivers,
                                                   const Progress& progress = {});

}  // namespace epura::edges
