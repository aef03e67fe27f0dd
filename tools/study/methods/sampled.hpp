// SPDX-License-Identifier: Apache-2.0
// Visibility by points along the edges [Appel. The notion of quantitative invisibility. ACM 1967, in its simplest
// form].
//
// An edge is divided into equal parts with a point in the middle of each. Each point is tested against the triangles
// near its position, the nearest first, with the same index as in the exact method. If two neighbouring points differ,
// the position of the change is found by bisection. A part of an edge that is shown wrongly contains no point, so it is
// shorter than the distance between two points: this bounds the error.
#pragma once

#include "visibility/visibility.hpp"

namespace epura::study {

struct Sampling {
  double density;  ///< points per view unit; every edge has at least one
  int halvings;    ///< bisections of the interval with a change
};

visibility::HiddenSpans find_hidden_by_samples(const world::World& world, const view::ProjectedScene& view,
                                               const edges::FeatureEdges& drawn, const Sampling& sampling,
                                               Progress progress = {});

}  // namespace epura::study
