// SPDX-License-Identifier: Apache-2.0
// Angles of cones that end in a rounded edge: where cone and edge touch, nothing can be measured, so the angle of the
// cone and its other end determine it.
#pragma once

#include <array>

#include "features/part_features.hpp"
#include "sizes/anchors.hpp"
#include "sizes/view_choice.hpp"

namespace epura::sheet {

/// Whether a dimension of its angle stands for the diameter and the place of one end, the rounded one. Cones whose
/// point is farther away than the models are large have none: the dimension line would be off the sheet.
bool has_angle(const features::ConeFeature& cone, double size);

/// The end that is rounded; one of them must be.
inline int rounded_end(const features::ConeFeature& cone) { return cone.rounded[0] ? 0 : 1; }

/// Whether a dimension is the angle between two opposite sides of a cone.
bool is_angle_of(const AnchoredDimension& dimension, const features::ConeFeature& cone);

/// A view across the axis of a cone whose outline shows both sides of its rounded edge, or else the first one across;
/// null if there is none.
const NamedProjection* view_of_angle(const features::ConeFeature& cone, const features::PartFeatures& features,
                                     const ViewChoice& views);

/// The point of the cone, and the ends of its sides in a view across its axis.
std::array<Vec3, 3> anchors_of_angle(const features::ConeFeature& cone, const projection::Projection& across);

}  // namespace epura::sheet
