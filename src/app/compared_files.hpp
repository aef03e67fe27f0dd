// SPDX-License-Identifier: Apache-2.0
// The files of `epura compare` -> pictures: drawings are read, models and scene files are drawn.
#pragma once

#include <array>

#include "app/options.hpp"
#include "compare/read_pictures.hpp"

namespace epura {

/// Two models or scenes are drawn to one scale, that of the first, and parallel views are placed so that what has not
/// changed in space lies in the same place. Throws Error as reading and drawing do.
std::array<compare::PictureFile, 2> pictures_to_compare(const CompareOptions& options);

}  // namespace epura
