// SPDX-License-Identifier: Apache-2.0
// Widths across flats of nuts, heads of screws and sockets.
#pragma once

#include "sizes/planning.hpp"

namespace epura::sheet {

/// Whether the size of the models along an axis of the world is that of a hexagon; `across_flats`: between two flats.
bool is_extent(const features::HexagonFeature& hexagon, int axis, const DimensionSubject& subject, bool across_flats);

/// Whether a length between two points along a unit vector is the width of a hexagon across flats.
bool is_across_flats(const features::HexagonFeature& hexagon, const Vec3& along, const Vec3& from, const Vec3& to);

/// Whether one note can describe both.
bool are_equal(const features::HexagonFeature& a, const features::HexagonFeature& b);

/// Whether the size of the models along an axis is that across the corners of a hexagon whose width a view shows.
bool is_across_corners(const Planning& plan, int axis);

/// The width of each hexagon, of equal ones once, without those that are the size of the models, the angle of one that
/// is turned, and positions. On the
/// axis of a hexagon that is as large as the models, nothing needs one.
Planned hexagon_dimensions(const Planning& plan);

}  // namespace epura::sheet
