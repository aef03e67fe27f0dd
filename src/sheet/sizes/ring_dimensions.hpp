// SPDX-License-Identifier: Apache-2.0
// Round grooves and beads about an axis: the circle on which the centres of their section lie, and its place.
#pragma once

#include <vector>

#include "features/part_features.hpp"
#include "sizes/planning.hpp"

namespace epura::sheet {

/// The numbers of tori about an axis of the world that an edge ends: the size and place of their rings do not follow
/// from faces beside them, as those of fillets do.
std::vector<int> find_rings(const features::PartFeatures& features);

/// Diameters of rings in a view across their axis, and their places; the radius of their section is another dimension.
Planned ring_dimensions(const Planning& plan);

}  // namespace epura::sheet
