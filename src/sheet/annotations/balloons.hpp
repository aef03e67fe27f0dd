// SPDX-License-Identifier: Apache-2.0
// Balloons: circles with the numbers of the items of a parts list (ISO 6433) or of characteristics (AS9102), and
// leaders.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dimensions/dimensions.hpp"
#include "sheet/marks.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Where the leader of a balloon ends.
struct BalloonTarget {
  std::string number;
  Vec2 point;            ///< on paper; the middle of what it is beside
  bool on_line = false;  ///< the leader ends with an arrow on a line instead of a dot on a face
  /// What the balloon stands beside, with a leader to its border only where there is no room at it.
  std::optional<TurnedBox> beside{};
};

/// Least height of lettering, mm. ISO 3098-1.
inline constexpr double smallest_lettering = 2.5;

/// Sizes of balloons beside dimensions of this text height, mm. Their numbers are larger than these texts.
double balloon_text(double dimension_text);
double balloon_radius(double dimension_text);

/// The room around a view with balloons, mm.
double balloon_room(double dimension_text);

/// Places balloons around a view, in rows and columns where possible, or beside what they number: their circles overlap
/// nothing, leaders cross each other, dimensions and lettering only if there is no other way. All
/// targets are points of the view, or none is. Adds them to the layer; returns the numbers of those for which there is
/// no place.
std::vector<std::string> place_balloons(Layer& layer, std::span<const BalloonTarget> targets,
                                        const drawing::ViewDrawing& view, const DimensionStyle& style,
                                        const Neighbours& neighbours);

}  // namespace epura::sheet
