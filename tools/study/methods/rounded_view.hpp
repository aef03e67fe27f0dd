// SPDX-License-Identifier: Apache-2.0
// Views with fewer digits: the result of the exact rule for coordinates as other programs might have computed them.
#pragma once

#include "view/projected_scene.hpp"

namespace epura::study {

/// The view, for visibility only: it cannot map or clip. Its contact tolerance allows for its rounding: four units of
/// its coarsest coordinate, as the usual tolerance is four cells of the grid. The grid has 2^bits cells across the
/// window, 4 <= bits <= 30. Coordinates remain doubles.
view::ProjectedScene on_coarser_grid(const view::ProjectedScene& view, int bits);

/// Page coordinates and depth rounded to 32-bit floats: the best that a pipeline of floats could deliver.
view::ProjectedScene in_floats(const view::ProjectedScene& view);

}  // namespace epura::study
