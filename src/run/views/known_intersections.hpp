// SPDX-License-Identifier: Apache-2.0
// Intersections that one view of a world has found, for the others: between triangles that refinement leaves alone,
// they are the same in all views.
#pragma once

#include <optional>
#include <vector>

#include "edges/find_edges.hpp"
#include "refine/refine_world.hpp"
#include "report/report.hpp"
#include "view/projected_scene.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

struct KnownIntersections {
  double normalisation, contact, crease_angle, part_angle;  ///< on which they depend
  edges::KnownCrossings of_facets;                          ///< by triangles of the world before it is refined
  std::optional<std::vector<edges::FaceCrossing>> whole;  ///< the others: all that are drawn, where nothing is refined
  report::PlanStep step;                                  ///< of the search, without its times
};

/// What a view sees of a world.
struct SharedWorld {
  const world::World& world;
  const refine::RefinedWorld* refined;  ///< null if there is nothing to refine
  const view::ProjectedScene& view;
  const edges::EdgeOptions& options;
};

/// Returns what a view has found: the edges that it draws, and where facets cross though their surfaces only touch.
KnownIntersections known_intersections(const SharedWorld& shared, const edges::FeatureEdges& drawn,
                                       const std::vector<edges::FaceCrossing>& contacts, const report::PlanStep& step);

/// Whether a view has the same intersections, apart from refinement.
bool has_same(const KnownIntersections& known, const SharedWorld& shared);

/// Returns what is known of the triangles that a view draws.
edges::KnownCrossings settled_by(const KnownIntersections& known, const SharedWorld& shared);

}  // namespace epura::pipeline
