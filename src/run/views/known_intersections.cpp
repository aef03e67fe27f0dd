// SPDX-License-Identifier: Apache-2.0
#include "views/known_intersections.hpp"

#include <cstddef>
#include <utility>

namespace epura::pipeline {

KnownIntersections known_intersections(const SharedWorld& shared, std::vector<edges::FaceCrossing> of_facets,
                                       const edges::FeatureEdges& drawn, const report::PlanStep& step) {
  KnownIntersections known{shared.view.map.normalisation,
                           shared.view.contact.in_space,
                           shared.options.crease_angle,
                           shared.options.part_angle,
                           {std::move(of_facets), {}},
                           std::nullopt,
                           step};
  known.step.times = {};
  if (shared.refined != nullptr) {
    known.of_facets.is_settled.assign(shared.refined->triangles.size(), 1);
    known.of_facets = edges::renumbered(known.of_facets, shared.refined->kept, shared.world.triangles.size());
  } else {
    known.of_facets.is_settled.assign(shared.world.triangles.size(), 1);
    known.whole = edges::intersections_of(drawn);
  }
  return known;
}

bool has_same(const KnownIntersections& known, const SharedWorld& shared) {
  return known.normalisation == shared.view.map.normalisation && known.contact == shared.view.contact.in_space &&
         known.crease_angle == shared.options.crease_angle && known.part_angle == shared.options.part_angle;
}

edges::KnownCrossings settled_by(const KnownIntersections& known, const SharedWorld& shared) {
  if (shared.refined == nullptr) return known.of_facets;
  std::vector<int> numbers(shared.world.triangles.size(), -1);
  const std::vector<int>& kept = shared.refined->kept;
  for (std::size_t t = 0; t < kept.size(); ++t)
    if (kept[t] >= 0) numbers[static_cast<std::size_t>(kept[t])] = static_cast<int>(t);
  return edges::renumbered(known.of_facets, numbers, shared.refined->triangles.size());
}

}  // namespace epura::pipeline
