// SPDX-License-Identifier: Apache-2.0
// Visibility by points along the edges [Appel. The notion of quantitative invisibility. ACM 1967, in its plainest
// form].
//
// Points stand in the middle of equal parts of an edge. Each is looked up among the triangles near its place, the
// nearest first, by the same index as the exact method uses. Where two neighbours differ, the place of the change is
// bisected. A part of an edge that is shown wrongly contains no point, so it is shorter than the distance of two
// points: that is the bound of the error.
#pragma once

#include "visibility/visibility.hpp"

namespace epura::study {

struct Sampling {
  double density;  ///< points per view unit; every edge has at least one
  int halvings;    ///< of the interval in which a change lies
};

visibility::HiddenSpans find_hidden_by_samples(const scene::World& world, const view::ProjectedScene& view,
                                               const edges::FeatureEdges& drawn, const Sampling& sampling,
                                               Progress progress = {});

}  // namespace epura::study
