// SPDX-License-Identifier: Apache-2.0
// Converts the files of `epura compare` to pictures: drawings are read, models and scene files are drawn.
#pragma once

#include <array>

#include "compare/read_pictures.hpp"
#include "snapshot/compare.hpp"

namespace epura {

/// Returns the pictures of both files. Two models or scenes are drawn at the scale of the first, and parallel views are
/// aligned so that geometry unchanged in space has the same position. Throws Error like reading and drawing.
std::array<compare::PictureFile, 2> pictures_to_compare(const CompareOptions& options);

}  // namespace epura
