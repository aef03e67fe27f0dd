// SPDX-License-Identifier: Apache-2.0
// Model -> the bytes of a file.
#pragma once

#include <string>

#include "solid.hpp"

namespace samples {

/// Wavefront OBJ: one `o` group a solid, polygons as they are.
std::string to_obj(const Model& model);

/// Binary STL: triangles in single precision, all solids in one.
std::string to_stl(const Model& model);

}  // namespace samples
