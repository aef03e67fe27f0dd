// SPDX-License-Identifier: Apache-2.0
#include "views/known_intersections.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace epura::pipeline {

KnownIntersections known_intersections(const SharedWorld& shared, const edges::FeatureEdges& drawn,
                                       const std::vector<edges::FaceCrossing>& contacts, const report::PlanStep& step) {
  const world::World& seen = shared.refined != nullptr ? *shared.refined : shared.world;
  std::vector<edges::FaceCrossing> intersections = edges::intersections_of(drawn);
  KnownIntersections known{shared.view.map.normalisation,
                           shared.view.contact.in_space,
                           shared.options.crease_angle,
                           shared.options.part_angle,
                           {contacts, std::vector<char>(seen.triangles.size(), 1)},
                           std::nullopt,
                           step};
  known.step.times = {};
  if (shared.refined != nullptr) {
    std::ranges::copy(intersections, std::back_inserter(known.of_facets.found));
    known.of_facets = edges::renumbered(known.of_facets, shared.refined->kept, shared.world.triangles.size());
  } else {
    known.whole = std::move(intersections);
  }
  return known;
}

bool has_same(const KnownIntersections& known, const SharedWorld& shared) {
  return known.normalisation == shared.view.map.normalisation && known.contact == shared.view.contact.in_space &&
         known.crease_angle == shared.options.crease_angle && known.part_angle == shared.options.part_angle;
}

edges::KnownCrossings settled_by(const KnownIntersections& known, const SharedWorld& shared) {
  edges::KnownCrossings all = known.of_facets;
  if (known.whole) std::ranges::copy(*known.whole, std::back_inserter(all.found));
  std::sort(all.found.begin(), all.found.end());
  if (shared.refined == nullptr) return all;
  std::vector<int> numbers(shared.world.triangles.size(), -1);
  const std::vector<int>& kept = shared.refined->kept;
  for (std::size_t t = 0; t < kept.size(); ++t)
    if (kept[t] >= 0) numbers[static_cast<std::size_t>(kept[t])] = static_cast<int>(t);
  return edges::renumbered(all, numbers, shared.refined->triangles.size());
}

}  // namespace epura::pipeline
