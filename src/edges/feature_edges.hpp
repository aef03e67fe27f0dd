// SPDX-License-Identifier: Apache-2.0
// Which mesh edges are drawn: contours, boundaries, creases.
#pragma once

#include <optional>
#include <vector>

#include "edges/edge_kind.hpp"
#include "edges/find_edges.hpp"
#include "edges/slivers.hpp"
#include "view/projected_scene.hpp"

namespace epura::edges {

/// For every edge of a model why it is drawn, or nothing.
///
/// Orientation of faces is not used: an edge is a contour when its two triangles lie on the same side of it on the
/// page, or when one of them is seen edge-on; so inside-out, one-sided and randomly oriented surfaces are drawn alike.
/// Outlines of cuts are always drawn. Throws OutOfTime.
std::vector<std::optional<EdgeKind>> feature_edges(const scene::World& world, const view::ProjectedScene& view,
                                                   int model, const EdgeOptions& options,
                                                   const Progress& progress = {});

/// The same where the model's slivers in the view are known.
std::vector<std::optional<EdgeKind>> feature_edges(const view::ProjectedScene& view, const EdgeOptions& options,
                                                   const EdgeSurroundings& around, const Slivers& slivers,
                                                   const Progress& progress = {});

}  // namespace epura::edges
