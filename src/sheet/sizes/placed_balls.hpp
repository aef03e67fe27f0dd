// SPDX-License-Identifier: Apache-2.0
// Spheres that have a place of their own: dimples, knobs, ball ends.
#pragma once

#include <vector>

#include "sheet/notation.hpp"
#include "sizes/automatic.hpp"

namespace epura::sheet {

/// Numbers of the spheres that are no corners of fillets or rounded edges, whose radius they would have.
std::vector<int> find_placed_balls(const features::PartFeatures& features, const Notation& notation);

/// Whether the models end on a sphere along an axis of the world, so that its radius gives its place there.
bool ends_models(const features::BallFeature& ball, int axis, const features::Extent& extent);

}  // namespace epura::sheet
