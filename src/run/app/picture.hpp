// SPDX-License-Identifier: Apache-2.0
// `epura picture`: a projection seen from outside.
#pragma once

#include "app/options.hpp"

namespace epura {

/// Draws and writes the files. Returns the exit code. Throws Error.
int draw_picture(PictureOptions options);

}  // namespace epura
