// SPDX-License-Identifier: Apache-2.0
// Assigns overall dimensions to the clearest views before they are drawn, and estimates the room they need.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "features/true_extents.hpp"
#include "scene/description.hpp"
#include "sizes/named_projection.hpp"

namespace epura::sheet {

/// Splits an overall dimension without a direction into overall width, height and depth, each once and in the clearest
/// of the views: width and height from the front and depth from the side, in preference to other orthographic views
/// along a world axis. Aligned sections show sizes along and around the axes of their turns. Sizes that no view shows
/// in true length are omitted, and so is a diameter that is already there: the diameter of a shaft is both its width
/// and its depth. If the dimension names a view, only that view counts. Throws Error{input} if nothing is left.
std::vector<scene::DimensionDescription> overall_dimensions(const scene::DimensionDescription& overall,
                                                            std::span<const NamedProjection> views,
                                                            const std::array<features::Extent, 3>& extents);

/// Millimetres on paper to be kept free around the ink of a view.
struct Room {
  Vec2 before{0, 0};  ///< on the left and below
  Vec2 after{0, 0};   ///< on the right and above
};

/// The room that the dimensions of one view usually need, with texts `text_height` mm high. Dimensions are positioned
/// only once there is a drawing: some may need more room, many need less.
Room dimension_room(std::span<const scene::DimensionDescription> dimensions, const projection::Projection& projection,
                    double text_height);

}  // namespace epura::sheet
