// SPDX-License-Identifier: Apache-2.0
// Which edges are worth the time where there is little: long ones, and those of which something is seen.
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.hpp"
#include "edges/find_edges.hpp"
#include "view/projected_scene.hpp"
#include "world/world.hpp"

namespace epura::visibility {

/// The numbers of the edges, by their length on the page.
std::vector<int> longest_first(const view::ProjectedScene& view, const std::vector<edges::FeatureEdge>& edges);

/// Returns all edges but the `count` longest of those whose middle no triangle hides, ascending: a model of many parts
/// hides most of its longest edges. If all are hidden, the `count` longest are left out. Where time runs out, fewer are
/// tried.
std::vector<int> all_but_longest_in_sight(const world::World& world, const view::ProjectedScene& view,
                                          const edges::FeatureEdges& drawn, std::size_t count, Progress progress = {});

}  // namespace epura::visibility
