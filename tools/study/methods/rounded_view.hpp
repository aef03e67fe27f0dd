// SPDX-License-Identifier: Apache-2.0
// Views with fewer digits: what the exact rule makes of coordinates that others would have computed.
#pragma once

#include "visibility/hiding_rule.hpp"

namespace epura {

/// A view, and a contact tolerance that forgives its rounding: four units of its coarsest coordinate, as contact_of
/// forgives four cells of the usual grid.
struct RoundedView {
  ProjectedScene view;  ///< of use for visibility only: it cannot map or clip
  Contact contact;
};

/// The page grid has 2^bits cells across the window, 4 <= bits <= 30. Coordinates stay doubles.
RoundedView on_coarser_grid(const ProjectedScene& view, const Contact& contact, int bits);

/// Page coordinates and depth rounded to 32-bit floats: the best that a pipeline of floats could deliver.
RoundedView in_floats(const ProjectedScene& view, const Contact& contact);

}  // namespace epura
