// SPDX-License-Identifier: Apache-2.0
// Dimensions of plane faces that are perpendicular to no axis of the world.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sizes/anchors.hpp"
#include "sizes/coordinates.hpp"
#include "sizes/feature_table.hpp"
#include "sizes/planning.hpp"
#include "sizes/view_choice.hpp"

namespace epura::sheet {

/// Whether an angle stands for the places of the ends of a slope: where a rounded corner ends the models, there is
/// nothing to measure to.
bool has_angle(const features::BevelFeature& slope, const DimensionSubject& subject);

/// The end of a slope whose place along an axis follows from the angle of the slope and its other end.
struct AngledEnd {
  std::size_t end;
  int axis;
};
/// The one whose place cannot be written exactly, where the angle is a multiple of half a degree, and no other face
/// gives the place; nothing if there is none, or if `has_angle`.
std::optional<AngledEnd> angled_end(const features::BevelFeature& slope, const DimensionSubject& subject,
                                    const FeatureTable& table, const Notation& notation);

/// Whether the angle of a slope gives the size of the models along an axis.
bool is_over_slope(const Planning& plan, int axis);

/// Whether a dimension is the angle between a slope and an axis of the world.
bool is_angle_of(const AnchoredDimension& dimension, const features::BevelFeature& slope);

/// Whether the angle of one slope can stand for that of the other, as in "2× 60°".
bool are_equal(const features::BevelFeature& a, const features::BevelFeature& b);

/// Whether a dimension gives the angle of a slope: its own, or "2×" that of an equal one among all.
bool gives_angle(const AnchoredDimension& dimension, const features::BevelFeature& slope,
                 const std::vector<features::BevelFeature>& all);

/// Chamfered corners have a note; other slopes have an angle, the positions of their ends, or of one and an angle,
/// those of the largest ones first.
Planned slope_dimensions(const Planning& plan);

/// The place of a step along its axis, in the view that shows it best; nothing if none does. `all_points` are those of
/// the models.
std::optional<Coordinate> coordinate_of(const features::LevelFeature& level, const ViewChoice& views,
                                        const std::vector<Vec3>& all_points, double slack);

/// The area below which a face is no step or slope to be dimensioned, for models in a box.
double min_area(const Box& box);

/// Coordinates of the steps that are not known yet, at most `max_levels` along one axis in a view, the largest ones.
Planned level_positions(const DimensionSubject& subject, const ViewChoice& views, const Coordinates& known);

}  // namespace epura::sheet
