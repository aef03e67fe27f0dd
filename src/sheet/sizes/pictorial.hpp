// SPDX-License-Identifier: Apache-2.0
// Dimensions of axonometric views: along the axes, with extension lines along another one, and diameters and radii at
// ellipses. ISO 129-1.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sizes/automatic.hpp"

namespace epura::sheet {

/// The first uncut parallel view, of those with this name if it is not empty; null if there is another one along an
/// axis of the world, in which sizes have their true lengths.
const NamedProjection* only_pictorial(std::span<const NamedProjection> views, const std::string& name);

/// Width, depth and height; if `wanted` is automatic, diameters of holes, shafts and bosses, radii of arcs, and
/// places along the axes of holes that are on no pitch circle.
std::vector<scene::DimensionDescription> pictorial_dimensions(const scene::DimensionDescription& wanted,
                                                              const NamedProjection& view,
                                                              const DimensionSubject& subject,
                                                              const Notation& notation);

/// The circles of the features whose size or place such a dimension gives, beside its own: one of them must be seen. A
/// diameter or radius of which the view does not show its own circle stands at another one.
std::vector<scene::FeatureCircle> rims_of(const scene::DimensionDescription& dimension,
                                          const features::PartFeatures& features);

}  // namespace epura::sheet
