// SPDX-License-Identifier: Apache-2.0
// Positions of axes: along the axes of the world across them, and along slopes.
#pragma once

#include <optional>
#include <span>

#include "sheet/dimensions/planning.hpp"

namespace epura::sheet {

/// The direction across an axis, along the face on which a feature begins, that is no axis of the world; nothing if the
/// axis is along one of the world, or perpendicular to none.
std::optional<Vec3> slanted_across(const Vec3& axis);

/// Adds the positions of equal features with parallel axes across these: along axes of the world in the view that sees
/// them come towards it, `along` if it shows the direction; along a slope from the end of the face on which they begin.
void add_positions(Planning& plan, std::span<const Vec3> centres, const Vec3& axis, const NamedProjection* along);

}  // namespace epura::sheet
