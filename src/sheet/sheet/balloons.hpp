// SPDX-License-Identifier: Apache-2.0
// Balloons: circles with the numbers of the items of a parts list, and leaders. ISO 6433.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sheet/dimensions/dimensions.hpp"
#include "sheet/dimensions/marks.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Where the leader of a balloon ends.
struct BalloonTarget {
  std::string number;
  Vec2 point;            ///< on paper
  bool on_line = false;  ///< the leader ends with an arrow on a line instead of a dot on a face
};

/// Sizes of balloons beside dimensions of this text height, mm. Their numbers are larger than these texts.
double balloon_text(double dimension_text);
double balloon_radius(double dimension_text);

/// The room around a view with balloons, mm.
double balloon_room(double dimension_text);

/// Places balloons around a view, in rows and columns where possible: their circles overlap nothing, leaders do not
/// cross each other, and cross dimensions and lettering only if there is no other way. `view` is the box of the view's
/// ink. Adds them to the layer; returns the numbers of those for which there is no place.
std::vector<std::string> place_balloons(Layer& layer, std::span<const BalloonTarget> targets, const Rectangle& view,
                                        const DimensionStyle& style, const Neighbours& neighbours);

}  // namespace epura::sheet
