// SPDX-License-Identifier: Apache-2.0
// Spheres that have a place of their own: dimples, knobs, ball ends.
#pragma once

#include <vector>

#include "sheet/dimensions/automatic.hpp"
#include "sheet/notation.hpp"

namespace epura::sheet {

/// Numbers of the spheres that are no corners of fillets or rounded edges, whose radius they would have.
std::vector<int> find_placed_balls(const design::DesignFeatures& features, const Notation& notation);

/// Whether the models end on a sphere along an axis of the world, so that its radius gives its place there.
bool ends_models(const design::DesignBall& ball, int axis, const design::Extent& extent);

}  // namespace epura::sheet
