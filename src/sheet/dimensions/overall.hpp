// Which views show the size of the models best.
#pragma once

#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "scene/description.hpp"
#include "scene/scene.hpp"

namespace epura {

/// Overall width, height and depth, each once, in the clearest of the drawings: width from the front, height from the
/// front, depth from the side, before other views along a world axis. What no drawing shows whole and in true length
/// is left out. `where` is for errors.
std::vector<DimensionDescription> overall_dimensions(const World& world, std::span<const Drawing> drawings,
                                                     const std::string& where);

}  // namespace epura
