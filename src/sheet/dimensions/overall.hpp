// SPDX-License-Identifier: Apache-2.0
// Assigns overall dimensions to the clearest views before they are drawn, and estimates the room they need.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "projection/projection.hpp"
#include "scene/description.hpp"
#include "scene/true_extents.hpp"

namespace epura::sheet {

struct NamedProjection {
  std::string name;  ///< of the view
  projection::Projection projection;
};

/// An overall dimension that names no direction, as overall width, height and depth: each once, in the clearest of the
/// views - width and height from the front, depth from the side, before other orthographic views along a world axis.
/// What no view shows in true length is left out, and so is a diameter that is already there: that of a shaft is its
/// width and its depth. Where it names a view, only that one counts. Throws Error{input} when nothing is left.
std::vector<scene::DimensionDescription> overall_dimensions(const scene::DimensionDescription& overall,
                                                            std::span<const NamedProjection> views,
                                                            const std::array<scene::Extent, 3>& extents);

/// Millimetres of paper to be kept free around the ink of a view.
struct Room {
  Vec2 before{0, 0};  ///< on the left and below
  Vec2 after{0, 0};   ///< on the right and above
};

/// What the dimensions of one view usually take, with texts `text_height` mm high. They are placed when there is a
/// drawing: some may want more, many take less.
Room dimension_room(std::span<const scene::DimensionDescription> dimensions, const projection::Projection& projection,
                    double text_height);

}  // namespace epura::sheet
