// SPDX-License-Identifier: Apache-2.0
// Views with fewer digits: what the exact rule makes of coordinates that others would have computed.
#pragma once

#include "view/projected_scene.hpp"

namespace epura::study {

/// The view, of use for visibility only: it cannot map or clip. Its contact tolerance forgives its rounding: four units
/// of its coarsest coordinate, as that of the usual grid forgives four cells. The grid has 2^bits cells across the
/// window, 4 <= bits <= 30. Coordinates stay doubles.
view::ProjectedScene on_coarser_grid(const view::ProjectedScene& view, int bits);

/// Page coordinates and depth rounded to 32-bit floats: the best that a pipeline of floats could deliver.
view::ProjectedScene in_floats(const view::ProjectedScene& view);

}  // namespace epura::study
