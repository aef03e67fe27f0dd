// SPDX-License-Identifier: Apache-2.0
// Chamfers where notes end, as "2×45°", by the faces there: no feature is asked.
#pragma once

#include <string>
#include <vector>

#include "sheet/notation.hpp"
#include "sizes/hole_walls.hpp"
#include "sizes/note_text.hpp"

namespace epura::sheet {

/// Across a slope: its length along and its angle to a face beside it, or the axis, in mm and degrees; and across that.
struct ChamferLegs {
  double along, across, angle;

  /// Whether a note gives a leg and the angle, or both legs.
  [[nodiscard]] bool suits(const NotedText& note, double doubt, double of_angle) const;
  [[nodiscard]] std::string text(const Notation& notation) const;
};

/// Of the cones and slanted planes at a point: of a plane by each face beside it.
std::vector<ChamferLegs> chamfers_at(const Vec3& point, const HoleWalls& walls, const world::World& world);

}  // namespace epura::sheet
