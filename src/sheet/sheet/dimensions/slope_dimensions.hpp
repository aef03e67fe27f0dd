// SPDX-License-Identifier: Apache-2.0
// Dimensions of plane faces that are perpendicular to no axis of the world.
#pragma once

#include "sheet/dimensions/anchors.hpp"
#include "sheet/dimensions/planning.hpp"

namespace epura::sheet {

/// Whether an angle stands for the places of the ends of a slope: where a rounded corner ends the models, there is
/// nothing to measure to.
bool has_angle(const features::BevelFeature& slope, const DimensionSubject& subject);

/// Whether a dimension is the angle between a slope and an axis of the world.
bool is_angle_of(const AnchoredDimension& dimension, const features::BevelFeature& slope);

/// Whether the angle of one slope can stand for that of the other, as in "2× 60°".
bool are_equal(const features::BevelFeature& a, const features::BevelFeature& b);

/// Chamfered corners have a note; other slopes have an angle or the positions of their ends, those of the largest ones
/// first.
Planned slope_dimensions(const Planning& plan);

}  // namespace epura::sheet
