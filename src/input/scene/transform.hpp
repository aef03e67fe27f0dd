// SPDX-License-Identifier: Apache-2.0
// Parses transforms of a model.
#pragma once

#include <string_view>

#include "base/vec.hpp"

namespace epura::scene {

/// Steps separated by spaces, applied from left to right: "scale:2", "scale:1,2,3", "translate:1,2,3",
/// "rotate:x,30" (x, y or z axis, degrees, right-handed), "matrix:16 numbers row-major".
/// Throws Error{input} naming the step.
Mat4 parse_transform(std::string_view text);

/// Returns the rotation of a model whose y axis points up (z towards the viewer) after which z points up.
Mat4 y_up_to_z_up();

}  // namespace epura::scene
